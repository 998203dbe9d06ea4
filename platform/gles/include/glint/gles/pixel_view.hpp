// Pixels that somebody else owns, as the presenter takes them.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glint/framebuffer.hpp>

namespace glint::gles {

/// An 8-bit picture in memory: R, G, B, A bytes, the top row first. Owns nothing; what it points to must live as long
/// as the call that it is handed to.
struct PixelView {
    const uint8_t *rgba8 = nullptr;
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    size_t stride_bytes = 0; ///< from a row to the next, at least 4 * width_px

    PixelView() = default;
    PixelView(const uint8_t *rgba8_, uint32_t width_px_, uint32_t height_px_, size_t stride_bytes_)
        : rgba8(rgba8_), width_px(width_px_), height_px(height_px_), stride_bytes(stride_bytes_) {}
    /// The whole picture. Not explicit: whoever takes a view takes a framebuffer.
    PixelView(const Framebuffer &picture)
        : PixelView(picture.rgba8(), picture.width_px(), picture.height_px(), picture.rgba8_stride_bytes()) {}
};

} // namespace glint::gles
