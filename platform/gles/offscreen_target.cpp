// Making and reading an off-screen colour buffer.
#include "gles/offscreen_target.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "gles/saved_state.hpp"
#include "gles/size_text.hpp"
#include "gles/texel_format.hpp"

namespace glint::gles {

namespace {

/// A texture with storage; 0 and an OpenGL error where that cannot be had.
GLuint create_texture(const Gl &gl, uint32_t width_px, uint32_t height_px) {
    // As the presenter's texture: then drawing a picture on it in its own size is a copy.
    const TexelFormat texel = fastest_texel_format(gl);
    const SavedTexture saved(gl);
    const TightRows tight_rows(gl, TightRows::Direction::unpack);
    GLuint texture = 0;
    gl.gen_textures(1, &texture);
    gl.bind_texture(GL_TEXTURE_2D, texture);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.tex_image_2d(GL_TEXTURE_2D, 0, texel.internal_format, static_cast<GLsizei>(width_px),
                    static_cast<GLsizei>(height_px), 0, texel.format, GL_UNSIGNED_BYTE, nullptr);
    return texture;
}

} // namespace

Status check_surface_size(const Gl &gl, uint32_t width_px, uint32_t height_px) {
    if (width_px == 0 || height_px == 0) {
        return Error(ErrorCode::bad_input,
                     "a surface of " + size_text(width_px, height_px) + " pixels, expected at least 1 x 1");
    }
    std::array<GLint, 2> viewport_px = {};
    gl.get_integerv(GL_MAX_VIEWPORT_DIMS, viewport_px.data());
    const GLint texture_px = gl.integer(GL_MAX_TEXTURE_SIZE);
    const auto widest = static_cast<uint32_t>(std::min(texture_px, viewport_px[0]));
    const auto tallest = static_cast<uint32_t>(std::min(texture_px, viewport_px[1]));
    if (width_px > widest || height_px > tallest) {
        return Error(ErrorCode::limit_exceeded, "a surface of " + size_text(width_px, height_px) +
                                                    " pixels, expected at most " + size_text(widest, tallest) +
                                                    " on this context");
    }
    return Done{};
}

Result<std::vector<uint8_t>> read_rgba8(const Gl &gl, uint32_t width_px, uint32_t height_px) {
    const size_t row_bytes = size_t{width_px} * 4;
    std::vector<uint8_t> pixels(row_bytes * height_px);
    const TightRows tight_rows(gl, TightRows::Direction::pack);
    gl.read_pixels(0, 0, static_cast<GLsizei>(width_px), static_cast<GLsizei>(height_px), GL_RGBA, GL_UNSIGNED_BYTE,
                   pixels.data());
    if (Status status = gl.check("glReadPixels"); !status) return std::move(status).error();
    // OpenGL's first row is the bottom one.
    for (size_t top = 0, bottom = height_px - 1; top < bottom; ++top, --bottom) {
        const auto row = [&](size_t y) { return pixels.begin() + static_cast<ptrdiff_t>(y * row_bytes); };
        std::swap_ranges(row(top), row(top + 1), row(bottom));
    }
    return pixels;
}

Status OffscreenTarget::resize(const Gl &gl, uint32_t width_px, uint32_t height_px) {
    if (Status status = gl.check_nothing_pending(); !status) return status;
    if (Status status = check_surface_size(gl, width_px, height_px); !status) return status;
    GLuint texture = create_texture(gl, width_px, height_px);
    if (Status status = gl.check("glTexImage2D"); !status) {
        gl.delete_textures(1, &texture);
        return status;
    }
    if (framebuffer_ == 0) gl.gen_framebuffers(1, &framebuffer_);
    bind(gl);
    gl.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    const GLenum completeness = gl.check_framebuffer_status(GL_FRAMEBUFFER);
    if (completeness != GL_FRAMEBUFFER_COMPLETE) {
        gl.framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
        gl.delete_textures(1, &texture);
        return Error(ErrorCode::unsupported, "glCheckFramebufferStatus says " + error_name(completeness) + " of " +
                                                 size_text(width_px, height_px) + " pixels");
    }
    gl.delete_textures(1, &texture_);
    texture_ = texture;
    width_px_ = width_px;
    height_px_ = height_px;
    return Done{};
}

} // namespace glint::gles
