// How far two pictures of the same scene are from each other.
#pragma once

#include <cstdint>

#include <glint/framebuffer.hpp>

namespace glint::bench {

struct PictureDifference {
    uint64_t pixels = 0;
    uint64_t differing = 0; ///< pixels with a channel that differs by more than 1 of 255
    uint8_t largest = 0;    ///< difference of any channel

    /// At most 0.1 % of the pixels differ: rounding along edges, not another picture.
    [[nodiscard]] bool same_picture() const { return differing * 1000 <= pixels; }
};

/// Compares the RGBA8 bytes. The pictures have the same size.
[[nodiscard]] PictureDifference compare_pictures(const Framebuffer &a, const Framebuffer &b);

} // namespace glint::bench
