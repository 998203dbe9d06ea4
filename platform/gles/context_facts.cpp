// Asking a context what it is.
#include <glint/gles/context_facts.hpp>

#include <array>

#include "gles/gl.hpp"

namespace glint::gles {

Result<ContextFacts> describe_context(const ProcLoader &load) {
    const Result<Gl> gl = Gl::load(load);
    if (!gl) return gl.error();
    std::array<GLint, 2> viewport_px = {};
    gl->get_integerv(GL_MAX_VIEWPORT_DIMS, viewport_px.data());
    const GLubyte *vendor = gl->get_string(GL_VENDOR);
    ContextFacts facts;
    facts.version = gl->version;
    facts.vendor = vendor != nullptr ? reinterpret_cast<const char *>(vendor) : "";
    facts.renderer = gl->renderer;
    facts.max_texture_px = static_cast<uint32_t>(gl->integer(GL_MAX_TEXTURE_SIZE));
    facts.max_viewport_width_px = static_cast<uint32_t>(viewport_px[0]);
    facts.max_viewport_height_px = static_cast<uint32_t>(viewport_px[1]);
    facts.takes_bgra = !gl->is_es || gl->has_es_extension("GL_EXT_texture_format_BGRA8888");
    facts.tells_loss = gl->get_graphics_reset_status != nullptr;
    if (Status status = gl->check("glGetIntegerv"); !status) return std::move(status).error();
    return facts;
}

} // namespace glint::gles
