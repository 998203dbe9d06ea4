// Fingerprints of a picture: equal pictures have equal hashes on every machine.
#include <glint/framebuffer.hpp>

#include <bit>
#include <cassert>

// The whole of XXH3 in this file, as static functions: no library to link, no symbol to leak.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace glint {

static_assert(std::endian::native == std::endian::little, "radiance_hash() promises little-endian bytes");

namespace {

/// Of rows of so many bytes, as if nothing lay between them.
uint64_t hash_of_rows(const void *first, size_t row_bytes, size_t stride_bytes, size_t rows) {
    if (stride_bytes == row_bytes) return XXH3_64bits(first, row_bytes * rows);
    XXH3_state_t state;
    XXH3_64bits_reset(&state);
    const auto *row = static_cast<const std::byte *>(first);
    for (size_t y = 0; y < rows; ++y, row += stride_bytes) XXH3_64bits_update(&state, row, row_bytes);
    return XXH3_64bits_digest(&state);
}

} // namespace

uint64_t Framebuffer::pixel_hash() const {
    return hash_of_rows(rgba8_.get(), size_t{width_px_} * 4, rgba8_stride_bytes_, height_px_);
}

uint64_t Framebuffer::radiance_hash() const {
    assert(has_radiance());
    return hash_of_rows(radiance_.get(), size_t{width_px_} * 3 * sizeof(float), radiance_stride_bytes_, height_px_);
}

} // namespace glint
