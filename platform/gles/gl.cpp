// Loading entry points and asking a context what it is.
#include "gles/gl.hpp"

#include <cstdio>
#include <string_view>

#include "gles/extension_list.hpp"

namespace glint::gles {

namespace {

/// Collects the names of the functions that are not there, to report them together.
class EntryPoints {
public:
    explicit EntryPoints(const ProcLoader &load_proc) : load_proc_(load_proc) {}

    template <typename Function> void get(Function &function, const char *name) {
        function = reinterpret_cast<Function>(load_proc_(name));
        if (function == nullptr) missing_ += std::string(missing_.empty() ? "" : ", ") + name;
    }

    [[nodiscard]] Status status() const {
        if (missing_.empty()) return Done{};
        return Error(ErrorCode::unsupported, "the OpenGL context has no " + missing_);
    }

private:
    const ProcLoader &load_proc_;
    std::string missing_;
};

Status load_es2(Gl &gl, const ProcLoader &load_proc) {
    EntryPoints entry(load_proc);
    entry.get(gl.active_texture, "glActiveTexture");
    entry.get(gl.attach_shader, "glAttachShader");
    entry.get(gl.bind_attrib_location, "glBindAttribLocation");
    entry.get(gl.bind_buffer, "glBindBuffer");
    entry.get(gl.bind_framebuffer, "glBindFramebuffer");
    entry.get(gl.bind_texture, "glBindTexture");
    entry.get(gl.blend_equation_separate, "glBlendEquationSeparate");
    entry.get(gl.blend_func_separate, "glBlendFuncSeparate");
    entry.get(gl.buffer_data, "glBufferData");
    entry.get(gl.check_framebuffer_status, "glCheckFramebufferStatus");
    entry.get(gl.color_mask, "glColorMask");
    entry.get(gl.compile_shader, "glCompileShader");
    entry.get(gl.create_program, "glCreateProgram");
    entry.get(gl.create_shader, "glCreateShader");
    entry.get(gl.delete_buffers, "glDeleteBuffers");
    entry.get(gl.delete_framebuffers, "glDeleteFramebuffers");
    entry.get(gl.delete_program, "glDeleteProgram");
    entry.get(gl.delete_shader, "glDeleteShader");
    entry.get(gl.delete_textures, "glDeleteTextures");
    entry.get(gl.disable, "glDisable");
    entry.get(gl.disable_vertex_attrib_array, "glDisableVertexAttribArray");
    entry.get(gl.draw_arrays, "glDrawArrays");
    entry.get(gl.enable, "glEnable");
    entry.get(gl.enable_vertex_attrib_array, "glEnableVertexAttribArray");
    entry.get(gl.finish, "glFinish");
    entry.get(gl.framebuffer_texture_2d, "glFramebufferTexture2D");
    entry.get(gl.gen_buffers, "glGenBuffers");
    entry.get(gl.gen_framebuffers, "glGenFramebuffers");
    entry.get(gl.gen_textures, "glGenTextures");
    entry.get(gl.get_booleanv, "glGetBooleanv");
    entry.get(gl.get_error, "glGetError");
    entry.get(gl.get_integerv, "glGetIntegerv");
    entry.get(gl.get_program_info_log, "glGetProgramInfoLog");
    entry.get(gl.get_programiv, "glGetProgramiv");
    entry.get(gl.get_shader_info_log, "glGetShaderInfoLog");
    entry.get(gl.get_shaderiv, "glGetShaderiv");
    entry.get(gl.get_string, "glGetString");
    entry.get(gl.get_uniform_location, "glGetUniformLocation");
    entry.get(gl.get_vertex_attribiv, "glGetVertexAttribiv");
    entry.get(gl.get_vertex_attrib_pointerv, "glGetVertexAttribPointerv");
    entry.get(gl.is_enabled, "glIsEnabled");
    entry.get(gl.link_program, "glLinkProgram");
    entry.get(gl.pixel_storei, "glPixelStorei");
    entry.get(gl.read_pixels, "glReadPixels");
    entry.get(gl.shader_source, "glShaderSource");
    entry.get(gl.tex_image_2d, "glTexImage2D");
    entry.get(gl.tex_parameteri, "glTexParameteri");
    entry.get(gl.tex_sub_image_2d, "glTexSubImage2D");
    entry.get(gl.uniform_2f, "glUniform2f");
    entry.get(gl.use_program, "glUseProgram");
    entry.get(gl.vertex_attrib_pointer, "glVertexAttribPointer");
    entry.get(gl.viewport, "glViewport");
    return entry.status();
}

Status load_gl3_objects(Gl &gl, const ProcLoader &load_proc) {
    EntryPoints entry(load_proc);
    entry.get(gl.bind_sampler, "glBindSampler");
    entry.get(gl.bind_vertex_array, "glBindVertexArray");
    entry.get(gl.delete_vertex_arrays, "glDeleteVertexArrays");
    entry.get(gl.gen_vertex_arrays, "glGenVertexArrays");
    return entry.status();
}

/// Under whichever name the context has it.
void load_reset_status(Gl &gl, const ProcLoader &load_proc) {
    const char *name = nullptr;
    if (gl.version_number >= (gl.is_es ? 32 : 45))
        name = "glGetGraphicsResetStatus";
    else if (gl.has_es_extension("GL_KHR_robustness"))
        name = "glGetGraphicsResetStatusKHR";
    else if (gl.has_es_extension("GL_EXT_robustness"))
        name = "glGetGraphicsResetStatusEXT";
    if (name == nullptr) return;
    gl.get_graphics_reset_status = reinterpret_cast<PFNGLGETGRAPHICSRESETSTATUSEXTPROC>(load_proc(name));
}

std::string text(const Gl &gl, GLenum name) {
    const GLubyte *value = gl.get_string(name);
    return value != nullptr ? reinterpret_cast<const char *>(value) : "";
}

/// "OpenGL ES 3.2 Mesa ..." or "4.5 (Core Profile) ...".
bool read_version(Gl &gl) {
    constexpr std::string_view es = "OpenGL ES ";
    gl.is_es = gl.version.starts_with(es);
    const char *number = gl.version.c_str() + (gl.is_es ? es.size() : 0);
    int major = 0;
    int minor = 0;
    if (std::sscanf(number, "%d.%d", &major, &minor) != 2) return false;
    gl.version_number = 10 * major + minor;
    return true;
}

} // namespace

Result<Gl> Gl::load(const ProcLoader &load_proc) {
    Gl gl;
    if (Status status = load_es2(gl, load_proc); !status) return std::move(status).error();
    // Without a current context glGetString has nothing to say.
    gl.version = text(gl, GL_VERSION);
    if (gl.version.empty()) {
        return Error(ErrorCode::unsupported, "no OpenGL ES context is current in this thread");
    }
    gl.renderer = text(gl, GL_RENDERER);
    if (!read_version(gl) || gl.version_number < 20) {
        return Error(ErrorCode::unsupported,
                     "the OpenGL context is '" + gl.version + "', expected OpenGL ES 2.0 or newer");
    }
    if (gl.is_es) gl.extensions = text(gl, GL_EXTENSIONS);
    gl.has_gl3_objects = gl.version_number >= (gl.is_es ? 30 : 33);
    gl.has_sample_mask = gl.version_number >= (gl.is_es ? 31 : 32);
    gl.has_srgb_switch = !gl.is_es || gl.has_es_extension("GL_EXT_sRGB_write_control");
    gl.has_unpack_rows = gl.has_gl3_objects || gl.has_es_extension("GL_EXT_unpack_subimage");
    if (gl.has_gl3_objects) {
        if (Status status = load_gl3_objects(gl, load_proc); !status) return std::move(status).error();
    }
    load_reset_status(gl, load_proc);
    return gl;
}

GLenum Gl::next_error() const {
    const GLenum code = get_error();
    if (code == GL_CONTEXT_LOST_KHR) lost_ = true;
    return code;
}

Status Gl::check(const char *call) const {
    const GLenum code = next_error();
    if (code == GL_NO_ERROR) return Done{};
    const ErrorCode kind = code == GL_OUT_OF_MEMORY ? ErrorCode::limit_exceeded : ErrorCode::unsupported;
    return Error(kind, std::string(call) + " failed with " + error_name(code));
}

Status Gl::check_nothing_pending() const {
    const GLenum first = next_error();
    if (first == GL_NO_ERROR) return Done{};
    // An implementation may keep several flags; without a context some report an error for ever.
    for (int i = 0; i < 8 && get_error() != GL_NO_ERROR; ++i) {
    }
    return Error(ErrorCode::unsupported, error_name(first) + " was left by an OpenGL call made before");
}

GLint Gl::integer(GLenum name) const {
    GLint value = 0;
    get_integerv(name, &value);
    return value;
}

bool Gl::is_lost() const {
    if (!lost_ && get_graphics_reset_status != nullptr) lost_ = get_graphics_reset_status() != GL_NO_ERROR;
    return lost_;
}

bool Gl::has_es_extension(const char *name) const {
    return lists_extension(extensions, name);
}

std::string error_name(GLenum code) {
    switch (code) {
    case GL_NO_ERROR:
        return "GL_NO_ERROR";
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST_KHR:
        return "GL_CONTEXT_LOST";
    default:
        break;
    }
    char text[24];
    std::snprintf(text, sizeof text, "error 0x%04X", code);
    return text;
}

} // namespace glint::gles
