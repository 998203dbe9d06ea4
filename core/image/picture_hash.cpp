// Fingerprints of a picture: equal pictures have equal hashes on every machine.
#include <glint/framebuffer.hpp>

#include <bit>
#include <cassert>

// The whole of XXH3 in this file, as static functions: no library to link, no symbol to leak.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace glint {

static_assert(std::endian::native == std::endian::little, "radiance_hash() promises little-endian bytes");

uint64_t Framebuffer::pixel_hash() const {
    return XXH3_64bits(rgba8_.get(), size_t{width_px_} * height_px_ * 4);
}

uint64_t Framebuffer::radiance_hash() const {
    assert(has_radiance());
    return XXH3_64bits(radiance_.get(), size_t{width_px_} * height_px_ * 3 * sizeof(float));
}

} // namespace glint
