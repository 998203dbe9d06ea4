// Reading a context's state, and disturbing it.
#include "platform/gl_snapshot.hpp"

#include <array>
#include <stdexcept>

#include "gles/program.hpp"

namespace glint::test {

namespace {

struct NamedValue {
    const char *name;
    GLenum value;
    size_t count = 1;
    bool gl3 = false; ///< OpenGL ES 3.0 or desktop 3.3
};

constexpr NamedValue integers[] = {
    {"GL_ACTIVE_TEXTURE", GL_ACTIVE_TEXTURE},
    {"GL_ARRAY_BUFFER_BINDING", GL_ARRAY_BUFFER_BINDING},
    {"GL_BLEND_DST_ALPHA", GL_BLEND_DST_ALPHA},
    {"GL_BLEND_SRC_RGB", GL_BLEND_SRC_RGB},
    {"GL_BLEND_DST_RGB", GL_BLEND_DST_RGB},
    {"GL_BLEND_SRC_ALPHA", GL_BLEND_SRC_ALPHA},
    {"GL_BLEND_EQUATION_ALPHA", GL_BLEND_EQUATION_ALPHA},
    {"GL_BLEND_EQUATION_RGB", GL_BLEND_EQUATION_RGB},
    {"GL_COLOR_WRITEMASK", GL_COLOR_WRITEMASK, 4},
    {"GL_CULL_FACE_MODE", GL_CULL_FACE_MODE},
    {"GL_CURRENT_PROGRAM", GL_CURRENT_PROGRAM},
    {"GL_DEPTH_FUNC", GL_DEPTH_FUNC},
    {"GL_DEPTH_WRITEMASK", GL_DEPTH_WRITEMASK},
    {"GL_ELEMENT_ARRAY_BUFFER_BINDING", GL_ELEMENT_ARRAY_BUFFER_BINDING},
    {"GL_FRAMEBUFFER_BINDING", GL_FRAMEBUFFER_BINDING},
    {"GL_FRONT_FACE", GL_FRONT_FACE},
    {"GL_PACK_ALIGNMENT", GL_PACK_ALIGNMENT},
    {"GL_RENDERBUFFER_BINDING", GL_RENDERBUFFER_BINDING},
    {"GL_SCISSOR_BOX", GL_SCISSOR_BOX, 4},
    {"GL_STENCIL_FUNC", GL_STENCIL_FUNC},
    {"GL_STENCIL_REF", GL_STENCIL_REF},
    {"GL_STENCIL_WRITEMASK", GL_STENCIL_WRITEMASK},
    {"GL_UNPACK_ALIGNMENT", GL_UNPACK_ALIGNMENT},
    {"GL_VIEWPORT", GL_VIEWPORT, 4},
    {"GL_PACK_ROW_LENGTH", GL_PACK_ROW_LENGTH, 1, true},
    {"GL_PACK_SKIP_PIXELS", GL_PACK_SKIP_PIXELS, 1, true},
    {"GL_PACK_SKIP_ROWS", GL_PACK_SKIP_ROWS, 1, true},
    {"GL_PIXEL_PACK_BUFFER_BINDING", GL_PIXEL_PACK_BUFFER_BINDING, 1, true},
    {"GL_PIXEL_UNPACK_BUFFER_BINDING", GL_PIXEL_UNPACK_BUFFER_BINDING, 1, true},
    {"GL_UNPACK_IMAGE_HEIGHT", GL_UNPACK_IMAGE_HEIGHT, 1, true},
    {"GL_UNPACK_ROW_LENGTH", GL_UNPACK_ROW_LENGTH, 1, true},
    {"GL_UNPACK_SKIP_PIXELS", GL_UNPACK_SKIP_PIXELS, 1, true},
    {"GL_UNPACK_SKIP_ROWS", GL_UNPACK_SKIP_ROWS, 1, true},
    {"GL_VERTEX_ARRAY_BINDING", GL_VERTEX_ARRAY_BINDING, 1, true},
};

constexpr NamedValue capabilities[] = {
    {"GL_BLEND", GL_BLEND},
    {"GL_CULL_FACE", GL_CULL_FACE},
    {"GL_DEPTH_TEST", GL_DEPTH_TEST},
    {"GL_DITHER", GL_DITHER},
    {"GL_POLYGON_OFFSET_FILL", GL_POLYGON_OFFSET_FILL},
    {"GL_SAMPLE_ALPHA_TO_COVERAGE", GL_SAMPLE_ALPHA_TO_COVERAGE},
    {"GL_SAMPLE_COVERAGE", GL_SAMPLE_COVERAGE},
    {"GL_SCISSOR_TEST", GL_SCISSOR_TEST},
    {"GL_STENCIL_TEST", GL_STENCIL_TEST},
    {"GL_RASTERIZER_DISCARD", GL_RASTERIZER_DISCARD, 1, true},
};

// Not in the headers of OpenGL ES 3.0.
constexpr GLenum sample_mask = 0x8E51;
constexpr GLenum color_logic_op = 0x0BF2;
constexpr GLenum invert = 0x150A;

constexpr NamedValue attribute_values[] = {
    {"enabled", GL_VERTEX_ATTRIB_ARRAY_ENABLED},
    {"buffer", GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING},
    {"size", GL_VERTEX_ATTRIB_ARRAY_SIZE},
    {"type", GL_VERTEX_ATTRIB_ARRAY_TYPE},
    {"normalized", GL_VERTEX_ATTRIB_ARRAY_NORMALIZED},
    {"stride", GL_VERTEX_ATTRIB_ARRAY_STRIDE},
};

constexpr GLuint attributes_seen = 4;
constexpr GLuint texture_units_seen = 4;

void snap_texture_units(const gles::Gl &gl, GlSnapshot &snapshot) {
    const GLint active = gl.integer(GL_ACTIVE_TEXTURE);
    for (GLuint i = 0; i < texture_units_seen; ++i) {
        gl.active_texture(GL_TEXTURE0 + i);
        const std::string unit = "unit " + std::to_string(i);
        snapshot[unit + " texture"] = {gl.integer(GL_TEXTURE_BINDING_2D)};
        if (gl.has_gl3_objects) snapshot[unit + " sampler"] = {gl.integer(GL_SAMPLER_BINDING)};
    }
    gl.active_texture(static_cast<GLenum>(active));
}

void snap_attributes(const gles::Gl &gl, GlSnapshot &snapshot) {
    for (GLuint i = 0; i < attributes_seen; ++i) {
        const std::string attribute = "attribute " + std::to_string(i);
        for (const NamedValue &value : attribute_values) {
            GLint found = 0;
            gl.get_vertex_attribiv(i, value.value, &found);
            snapshot[attribute + " " + value.name] = {found};
        }
        void *pointer = nullptr;
        gl.get_vertex_attrib_pointerv(i, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
        snapshot[attribute + " pointer"] = {static_cast<GLint>(reinterpret_cast<intptr_t>(pointer))};
    }
}

/// Functions that only tests call.
template <typename Function> Function load_as(const gles::ProcLoader &load, const char *name) {
    return reinterpret_cast<Function>(load(name));
}

void bind_foreign_textures(const gles::Gl &gl, const gles::ProcLoader &load) {
    for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE2}) {
        gl.active_texture(unit);
        GLuint texture = 0;
        gl.gen_textures(1, &texture);
        gl.bind_texture(GL_TEXTURE_2D, texture);
        if (!gl.has_gl3_objects) continue;
        GLuint sampler = 0;
        load_as<PFNGLGENSAMPLERSPROC>(load, "glGenSamplers")(1, &sampler);
        // Would scale and repeat where the presenter must not.
        load_as<PFNGLSAMPLERPARAMETERIPROC>(load, "glSamplerParameteri")(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl.bind_sampler(unit - GL_TEXTURE0, sampler);
    }
}

void bind_foreign_vertices(const gles::Gl &gl) {
    if (gl.has_gl3_objects) {
        GLuint vertex_array = 0;
        gl.gen_vertex_arrays(1, &vertex_array);
        gl.bind_vertex_array(vertex_array);
    }
    std::array<GLuint, 3> buffers = {};
    gl.gen_buffers(3, buffers.data());
    gl.bind_buffer(GL_ARRAY_BUFFER, buffers[0]);
    gl.buffer_data(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW); // too short for any draw
    gl.vertex_attrib_pointer(0, 3, GL_UNSIGNED_BYTE, GL_TRUE, 20, reinterpret_cast<const void *>(12));
    gl.vertex_attrib_pointer(2, 2, GL_SHORT, GL_FALSE, 8, nullptr);
    gl.enable_vertex_attrib_array(0);
    gl.enable_vertex_attrib_array(2);
    gl.bind_buffer(GL_ARRAY_BUFFER, buffers[1]);
    gl.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
}

void use_foreign_program(const gles::Gl &gl) {
    Result<GLuint> program = gles::link_program(
        gl, "#version 100\nattribute vec4 p;\nvoid main() { gl_Position = p; }\n",
        "#version 100\nprecision mediump float;\nvoid main() { gl_FragColor = vec4(1.0, 0.0, 1.0, 0.5); }\n", "p");
    if (!program) throw std::runtime_error(program.error().text());
    gl.use_program(*program);
}

void lay_rows_with_gaps(const gles::Gl &gl) {
    gl.pixel_storei(GL_UNPACK_ALIGNMENT, 8);
    gl.pixel_storei(GL_PACK_ALIGNMENT, 2);
    if (!gl.has_gl3_objects) return;
    GLint value = 100;
    for (const GLenum parameter :
         {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_PACK_ROW_LENGTH,
          GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS}) {
        gl.pixel_storei(parameter, value++);
    }
    std::array<GLuint, 2> buffers = {};
    gl.gen_buffers(2, buffers.data());
    gl.bind_buffer(GL_PIXEL_UNPACK_BUFFER, buffers[0]);
    gl.bind_buffer(GL_PIXEL_PACK_BUFFER, buffers[1]);
}

void fail_every_test(const gles::Gl &gl, const gles::ProcLoader &load) {
    load_as<PFNGLBLENDFUNCSEPARATEPROC>(load, "glBlendFuncSeparate")(GL_DST_COLOR, GL_ZERO, GL_DST_ALPHA, GL_SRC_COLOR);
    load_as<PFNGLBLENDEQUATIONSEPARATEPROC>(load, "glBlendEquationSeparate")(GL_FUNC_REVERSE_SUBTRACT,
                                                                             GL_FUNC_SUBTRACT);
    load_as<PFNGLCULLFACEPROC>(load, "glCullFace")(GL_FRONT_AND_BACK);
    load_as<PFNGLFRONTFACEPROC>(load, "glFrontFace")(GL_CW);
    load_as<PFNGLDEPTHFUNCPROC>(load, "glDepthFunc")(GL_NEVER);
    load_as<PFNGLDEPTHMASKPROC>(load, "glDepthMask")(GL_FALSE);
    load_as<PFNGLSTENCILFUNCPROC>(load, "glStencilFunc")(GL_NEVER, 3, 0xff);
    load_as<PFNGLSTENCILMASKPROC>(load, "glStencilMask")(0x0f);
    load_as<PFNGLSCISSORPROC>(load, "glScissor")(1, 2, 3, 4);
    load_as<PFNGLSAMPLECOVERAGEPROC>(load, "glSampleCoverage")(0.0f, GL_FALSE);
    gl.viewport(3, 5, 7, 11);
    gl.color_mask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
    for (const NamedValue &capability : capabilities) {
        if (!capability.gl3 || gl.has_gl3_objects) gl.enable(capability.value);
    }
    if (gl.has_sample_mask) gl.enable(sample_mask);
    if (gl.has_srgb_switch) gl.enable(GL_FRAMEBUFFER_SRGB_EXT);
    if (gl.is_es) return;
    gl.enable(color_logic_op);
    load_as<PFNGLBLENDEQUATIONPROC>(load, "glLogicOp")(invert);
}

} // namespace

GlSnapshot take_snapshot(const gles::Gl &gl) {
    GlSnapshot snapshot;
    for (const NamedValue &integer : integers) {
        if (integer.gl3 && !gl.has_gl3_objects) continue;
        std::vector<GLint> values(integer.count);
        gl.get_integerv(integer.value, values.data());
        snapshot[integer.name] = std::move(values);
    }
    const auto snap_capability = [&](const char *name, GLenum capability) {
        snapshot[name] = {gl.is_enabled(capability)};
    };
    for (const NamedValue &capability : capabilities) {
        if (!capability.gl3 || gl.has_gl3_objects) snap_capability(capability.name, capability.value);
    }
    if (gl.has_sample_mask) snap_capability("GL_SAMPLE_MASK", sample_mask);
    if (gl.has_srgb_switch) snap_capability("GL_FRAMEBUFFER_SRGB", GL_FRAMEBUFFER_SRGB_EXT);
    if (!gl.is_es) snap_capability("GL_COLOR_LOGIC_OP", color_logic_op);
    snap_texture_units(gl, snapshot);
    snap_attributes(gl, snapshot);
    return snapshot;
}

void make_unusual(const gles::Gl &gl, const gles::ProcLoader &load) {
    use_foreign_program(gl);
    bind_foreign_textures(gl, load);
    bind_foreign_vertices(gl);
    lay_rows_with_gaps(gl);
    fail_every_test(gl, load);
}

} // namespace glint::test
