// The picture's memory.
#include <glint/framebuffer.hpp>

#include <algorithm>
#include <new>
#include <optional>
#include <string>

namespace glint {

namespace {

std::string size_text(uint32_t width_px, uint32_t height_px) {
    return std::to_string(width_px) + " x " + std::to_string(height_px) + " pixels";
}

Error no_pixels(uint32_t width_px, uint32_t height_px) {
    return {ErrorCode::bad_input, "a framebuffer of " + size_text(width_px, height_px) + ", expected at least 1 x 1"};
}

Error not_addressable(uint32_t width_px, uint32_t height_px) {
    return {ErrorCode::limit_exceeded, "a framebuffer of " + size_text(width_px, height_px) + " cannot be addressed"};
}

/// What is wrong with where rows begin, or nothing.
std::optional<std::string> stride_problem(const char *name, size_t stride_bytes, uint64_t row_bytes) {
    if (stride_bytes >= row_bytes) return std::nullopt;
    return std::string(name) + " rows of " + std::to_string(row_bytes) + " bytes do not fit a stride of " +
           std::to_string(stride_bytes);
}

} // namespace

Result<Framebuffer> Framebuffer::create(uint32_t width_px, uint32_t height_px, bool with_radiance) try {
    if (width_px == 0 || height_px == 0) return no_pixels(width_px, height_px);
    // 64-bit size first: 12 bytes a pixel for the floats must be addressable.
    const uint64_t wide = uint64_t{width_px} * height_px;
    if (wide > PTRDIFF_MAX / (3 * sizeof(float))) {
        return not_addressable(width_px, height_px);
    }
    const auto pixels = static_cast<size_t>(wide);
    Framebuffer framebuffer;
    framebuffer.width_px_ = width_px;
    framebuffer.height_px_ = height_px;
    framebuffer.rgba8_.reset(new (std::nothrow) uint8_t[pixels * 4]());
    if (with_radiance) framebuffer.radiance_.reset(new (std::nothrow) float[pixels * 3]());
    if (!framebuffer.rgba8_ || (with_radiance && !framebuffer.radiance_)) {
        return Error(ErrorCode::out_of_memory, "no memory for a framebuffer of " + size_text(width_px, height_px));
    }
    framebuffer.rgba8_stride_bytes_ = size_t{width_px} * 4;
    if (with_radiance) framebuffer.radiance_stride_bytes_ = size_t{width_px} * 3 * sizeof(float);
    return framebuffer;
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

Result<Framebuffer> Framebuffer::wrap(uint32_t width_px, uint32_t height_px, uint8_t *rgba8, size_t stride_bytes,
                                      float *radiance, size_t radiance_stride_bytes) try {
    if (width_px == 0 || height_px == 0) return no_pixels(width_px, height_px);
    if (!rgba8) return Error(ErrorCode::bad_input, "a framebuffer in no memory");
    const uint64_t row_bytes = uint64_t{width_px} * 4, light_bytes = uint64_t{width_px} * 3 * sizeof(float);
    // Where size_t has 32 bits a row of floats may already be too much.
    if (light_bytes > PTRDIFF_MAX) return not_addressable(width_px, height_px);
    if (!radiance)
        radiance_stride_bytes = 0;
    else if (radiance_stride_bytes == 0)
        radiance_stride_bytes = static_cast<size_t>(light_bytes);
    auto problem = stride_problem("8-bit", stride_bytes, row_bytes);
    if (!problem && radiance) problem = stride_problem("radiance", radiance_stride_bytes, light_bytes);
    if (!problem && (reinterpret_cast<uintptr_t>(radiance) | radiance_stride_bytes) % alignof(float) != 0) {
        problem = "radiance that is not aligned to its floats";
    }
    if (problem) return Error(ErrorCode::bad_input, std::move(*problem));
    // The last row need not have anything behind it.
    const uint64_t between = std::max(stride_bytes, radiance_stride_bytes);
    if (between > (PTRDIFF_MAX - light_bytes) / height_px) return not_addressable(width_px, height_px);

    Framebuffer framebuffer;
    framebuffer.width_px_ = width_px;
    framebuffer.height_px_ = height_px;
    framebuffer.rgba8_stride_bytes_ = stride_bytes;
    framebuffer.radiance_stride_bytes_ = radiance_stride_bytes;
    framebuffer.rgba8_ = {rgba8, Release{true}};
    framebuffer.radiance_ = {radiance, Release{true}};
    return framebuffer;
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

} // namespace glint
