// Where the picture lands: 8-bit RGBA for the screen, linear floats for files and measurements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <glint/export.hpp>
#include <glint/result.hpp>

namespace glint {

/// A picture in memory. Pixel (0, 0) is top left; rows follow each other from the top without gaps.
/// Holds zeroes (transparent black) until rendered to. Movable, not copyable.
class GLINT_API Framebuffer {
public:
    /// Width and height in pixels, each at least 1. Fails with limit_exceeded where memory for them is not to be had.
    /// Without `with_radiance` only the 8-bit picture is kept: a quarter of the memory traffic.
    [[nodiscard]] static Result<Framebuffer> create(uint32_t width_px, uint32_t height_px, bool with_radiance = true);

    [[nodiscard]] uint32_t width_px() const { return width_px_; }
    [[nodiscard]] uint32_t height_px() const { return height_px_; }

    /// R, G, B, A bytes; A is 255 where rendered. round(255 * clamp(c)) of the linear colour.
    [[nodiscard]] const uint8_t *rgba8() const { return rgba8_.get(); }
    [[nodiscard]] uint8_t *rgba8() { return rgba8_.get(); }
    [[nodiscard]] size_t rgba8_stride_bytes() const { return size_t{width_px_} * 4; }

    /// Linear R, G, B floats, unclamped; nullptr when made without radiance.
    [[nodiscard]] const float *radiance() const { return radiance_.get(); }
    [[nodiscard]] float *radiance() { return radiance_.get(); }
    [[nodiscard]] bool has_radiance() const { return radiance_ != nullptr; }

    /// XXH3-64 of the RGBA8 bytes, top row first: equal pictures have equal hashes on every machine.
    [[nodiscard]] uint64_t pixel_hash() const;
    /// XXH3-64 of the radiance floats' bits, as little-endian bytes, top row first. Asserts has_radiance().
    [[nodiscard]] uint64_t radiance_hash() const;

private:
    Framebuffer() = default;

    uint32_t width_px_ = 0;
    uint32_t height_px_ = 0;
    std::unique_ptr<uint8_t[]> rgba8_;
    std::unique_ptr<float[]> radiance_;
};

} // namespace glint
