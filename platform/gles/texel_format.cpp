// Choosing the byte order, and changing it.
#include "gles/texel_format.hpp"

#include <cstring>

namespace glint::gles {

namespace {

/// One 32-bit word a pixel: a form that compilers make vector code of. Bytes 1 and 3 stay, 0 and 2 trade places,
/// whichever end of the word they are at.
[[gnu::always_inline]] inline void copy(const uint8_t *from, uint8_t *to, size_t pixel_count) {
    for (size_t i = 0; i < pixel_count; ++i) {
        uint32_t pixel;
        std::memcpy(&pixel, from + 4 * i, sizeof pixel);
        const uint32_t odd = pixel & UINT32_C(0xff00ff00);
        const uint32_t even = pixel & UINT32_C(0x00ff00ff);
        const uint32_t swapped = odd | (even << 16) | (even >> 16);
        std::memcpy(to + 4 * i, &swapped, sizeof swapped);
    }
}

#if defined(__x86_64__)
/// The same loop with vectors twice as wide: half the time of an upload's swapping.
[[gnu::target("avx2")]] void copy_with_avx2(const uint8_t *from, uint8_t *to, size_t pixel_count) {
    copy(from, to, pixel_count);
}
#endif

} // namespace

TexelFormat fastest_texel_format(const Gl &gl) {
    constexpr TexelFormat rgba = {GL_RGBA, GL_RGBA, false};
    if (gl.renderer.find("llvmpipe") == std::string::npos) return rgba;
    // A desktop context has no BGRA internal format; asked for plain RGBA it follows the format of the pixels.
    if (!gl.is_es) return {GL_RGBA, GL_BGRA_EXT, true};
    if (gl.has_es_extension("GL_EXT_texture_format_BGRA8888")) return {GL_BGRA_EXT, GL_BGRA_EXT, true};
    return rgba;
}

void copy_red_blue_swapped(const uint8_t *from, uint8_t *to, size_t pixel_count) {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return copy_with_avx2(from, to, pixel_count);
#endif
    copy(from, to, pixel_count);
}

} // namespace glint::gles
