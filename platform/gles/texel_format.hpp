// In which order a texture keeps a pixel's four bytes: the drivers' R, G, B, A, or what is fastest in software.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gles/gl.hpp"

namespace glint::gles {

struct TexelFormat {
    GLint internal_format;
    GLenum format;
    bool red_blue_swapped; ///< the bytes are B, G, R, A
};

/// The order for textures that pictures are uploaded to, or drawn onto.
///
/// R, G, B, A, as the framebuffer has it, except for Mesa's llvmpipe. Its linear rasterizer draws an aligned rectangle
/// six times as fast as the general one (Mesa 22.3.6, 512 x 512, quiet: 0.1 ms against 0.6 ms), but takes it for BGRA
/// textures on BGRA surfaces only. Swapping the bytes while they are copied costs 0.03 ms. Swapping in the shader is no
/// way out: the linear rasterizer overlooks the swizzle and shows red as blue. Mesa 25.0.7 was seen not to use the
/// linear rasterizer in either order; there the swap is a small loss.
[[nodiscard]] TexelFormat fastest_texel_format(const Gl &gl);

/// Copies pixels of four bytes, exchanging the first and the third of each.
void copy_red_blue_swapped(const uint8_t *from, uint8_t *to, size_t pixel_count);

} // namespace glint::gles
