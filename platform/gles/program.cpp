// Compiling and linking, with the driver's words where it refuses.
#include "gles/program.hpp"

#include <string>

namespace glint::gles {

namespace {

/// The log of a shader or program, on one line.
template <typename GetInteger, typename GetLog>
std::string log_text(GLuint name, GetInteger get_integer, GetLog get_log) {
    GLint length = 0;
    get_integer(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(length > 0 ? length : 0), '\0');
    GLsizei written = 0;
    if (length > 0) get_log(name, length, &written, log.data());
    log.resize(static_cast<size_t>(written));
    for (char &c : log) c = c == '\n' ? ' ' : c;
    return log.empty() ? "no log" : log;
}

Result<GLuint> compile_shader(const Gl &gl, GLenum type, const char *source) {
    const GLuint shader = gl.create_shader(type);
    if (shader == 0) {
        if (Status status = gl.check("glCreateShader"); !status) return std::move(status).error();
    }
    gl.shader_source(shader, 1, &source, nullptr);
    gl.compile_shader(shader);
    GLint compiled = GL_FALSE;
    gl.get_shaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    Error error(ErrorCode::unsupported,
                "glCompileShader failed: " + log_text(shader, gl.get_shaderiv, gl.get_shader_info_log));
    gl.delete_shader(shader);
    return error;
}

} // namespace

Result<GLuint> link_program(const Gl &gl, const char *vertex_source, const char *fragment_source,
                            const char *attribute_name) {
    Result<GLuint> vertex_shader = compile_shader(gl, GL_VERTEX_SHADER, vertex_source);
    if (!vertex_shader) return vertex_shader;
    Result<GLuint> fragment_shader = compile_shader(gl, GL_FRAGMENT_SHADER, fragment_source);
    if (!fragment_shader) {
        gl.delete_shader(*vertex_shader);
        return fragment_shader;
    }
    const GLuint program = gl.create_program();
    gl.attach_shader(program, *vertex_shader);
    gl.attach_shader(program, *fragment_shader);
    gl.bind_attrib_location(program, 0, attribute_name);
    gl.link_program(program);
    // The program keeps what it needs of them.
    gl.delete_shader(*vertex_shader);
    gl.delete_shader(*fragment_shader);
    GLint linked = GL_FALSE;
    gl.get_programiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return program;
    Error error(ErrorCode::unsupported,
                "glLinkProgram failed: " + log_text(program, gl.get_programiv, gl.get_program_info_log));
    gl.delete_program(program);
    return error;
}

} // namespace glint::gles
