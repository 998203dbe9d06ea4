// Where the picture lands: 8-bit RGBA for the screen, linear floats for files and measurements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <glint/export.hpp>
#include <glint/result.hpp>

namespace glint {

/// A picture in memory, its own or the caller's. Pixel (0, 0) is top left; rows follow each other from the top.
/// Movable, not copyable; once moved from it must not be used.
class GLINT_API Framebuffer {
public:
    /// A picture in memory of its own, without gaps between rows; it holds zeroes (transparent black) until rendered
    /// to. Width and height in pixels, each at least 1. Fails with limit_exceeded where no memory could be large
    /// enough, and with out_of_memory. Without `with_radiance` only the 8-bit picture is kept: a quarter of the memory
    /// traffic.
    [[nodiscard]] static Result<Framebuffer> create(uint32_t width_px, uint32_t height_px, bool with_radiance = true);

    /// A picture in the caller's memory, which must outlive it and stays as it is until rendered to. A row begins
    /// `stride_bytes` behind the one above it, at least 4 * width_px; what lies between rows is never written. Likewise
    /// for `radiance`, floats for which each row takes at least 12 * width_px bytes, and a stride that is a multiple of
    /// 4; 0 = rows without gaps. nullptr = no radiance is kept. The two must not overlap.
    ///
    /// Fails with bad_input where there is no memory or no pixel, a stride is too small, or the floats are not aligned;
    /// with limit_exceeded where the rows together cannot be addressed.
    [[nodiscard]] static Result<Framebuffer> wrap(uint32_t width_px, uint32_t height_px, uint8_t *rgba8,
                                                  size_t stride_bytes, float *radiance = nullptr,
                                                  size_t radiance_stride_bytes = 0);

    [[nodiscard]] uint32_t width_px() const { return width_px_; }
    [[nodiscard]] uint32_t height_px() const { return height_px_; }

    /// R, G, B, A bytes; A is 255 where rendered. round(255 * clamp(c)) of the linear colour.
    [[nodiscard]] const uint8_t *rgba8() const { return rgba8_.get(); }
    [[nodiscard]] uint8_t *rgba8() { return rgba8_.get(); }
    /// From a row to the next one.
    [[nodiscard]] size_t rgba8_stride_bytes() const { return rgba8_stride_bytes_; }

    /// Linear R, G, B floats, unclamped; nullptr when made without radiance.
    [[nodiscard]] const float *radiance() const { return radiance_.get(); }
    [[nodiscard]] float *radiance() { return radiance_.get(); }
    /// From a row to the next one, a multiple of sizeof(float); 0 when made without radiance.
    [[nodiscard]] size_t radiance_stride_bytes() const { return radiance_stride_bytes_; }
    [[nodiscard]] bool has_radiance() const { return radiance_ != nullptr; }

    /// XXH3-64 of the RGBA8 bytes, top row first, without what lies between rows: equal pictures have equal hashes on
    /// every machine.
    [[nodiscard]] uint64_t pixel_hash() const;
    /// XXH3-64 of the radiance floats' bits, as little-endian bytes, top row first. Asserts has_radiance().
    [[nodiscard]] uint64_t radiance_hash() const;

private:
    /// Deletes what is the framebuffer's own.
    struct Release {
        bool is_callers;
        template <typename T> void operator()(T *memory) const {
            if (!is_callers) delete[] memory;
        }
    };

    Framebuffer() = default;

    uint32_t width_px_ = 0;
    uint32_t height_px_ = 0;
    size_t rgba8_stride_bytes_ = 0;
    size_t radiance_stride_bytes_ = 0;
    std::unique_ptr<uint8_t[], Release> rgba8_;
    std::unique_ptr<float[], Release> radiance_;
};

} // namespace glint
