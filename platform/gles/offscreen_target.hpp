// A colour buffer without a window: a framebuffer object with one texture.
#pragma once

#include <cstdint>
#include <vector>

#include <glint/result.hpp>

#include "gles/gl.hpp"

namespace glint::gles {

/// Fails with bad_input or limit_exceeded when a surface of that size cannot be had on this context.
[[nodiscard]] Status check_surface_size(const Gl &gl, uint32_t width_px, uint32_t height_px);

/// Reads the current framebuffer from its lower left corner: R, G, B, A bytes, rows without gaps, top row first.
[[nodiscard]] Result<std::vector<uint8_t>> read_rgba8(const Gl &gl, uint32_t width_px, uint32_t height_px);

/// The framebuffer object of an OffscreenSurface. Colour only: a depth buffer that nobody asked for
/// would cost Mesa's llvmpipe its fast path. The names die with the context; nothing is deleted here.
class OffscreenTarget {
public:
    /// Makes, or remakes, the colour buffer and binds it. Where that fails the old one stays.
    Status resize(const Gl &gl, uint32_t width_px, uint32_t height_px);
    void bind(const Gl &gl) const { gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_); }

    [[nodiscard]] uint32_t width_px() const { return width_px_; }
    [[nodiscard]] uint32_t height_px() const { return height_px_; }

private:
    uint32_t width_px_ = 0;
    uint32_t height_px_ = 0;
    GLuint framebuffer_ = 0;
    GLuint texture_ = 0;
};

} // namespace glint::gles
