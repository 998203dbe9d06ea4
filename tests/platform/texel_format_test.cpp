// The order of a texture's bytes, and changing it.
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "gles/texel_format.hpp"

namespace glint::test {
namespace {

TEST(texel_format, swapping_exchanges_red_and_blue_and_nothing_else) {
    // Around the widths that vector code works in.
    for (size_t count = 0; count < 70; ++count) {
        std::array<uint8_t, 71 * 4> from = {};
        std::array<uint8_t, 71 * 4> to = {};
        for (size_t i = 0; i < from.size(); ++i) from[i] = static_cast<uint8_t>(i * 37 + 11);
        gles::copy_red_blue_swapped(from.data(), to.data(), count);
        for (size_t pixel = 0; pixel <= 70; ++pixel) {
            const std::array<uint8_t, 4> found = {to[pixel * 4], to[pixel * 4 + 1], to[pixel * 4 + 2],
                                                  to[pixel * 4 + 3]};
            std::array<uint8_t, 4> expected = {};
            if (pixel < count) {
                expected = {from[pixel * 4 + 2], from[pixel * 4 + 1], from[pixel * 4], from[pixel * 4 + 3]};
            }
            ASSERT_EQ(found, expected) << "pixel " << pixel << " of " << count;
        }
    }
}

gles::Gl context_named(const char *renderer, const char *extensions, bool is_es) {
    gles::Gl gl;
    gl.renderer = renderer;
    gl.extensions = extensions;
    gl.is_es = is_es;
    return gl;
}

TEST(texel_format, bytes_are_swapped_for_llvmpipe_alone) {
    const char *bgra = "GL_EXT_a GL_EXT_texture_format_BGRA8888 GL_EXT_b";
    EXPECT_FALSE(gles::fastest_texel_format(context_named("Mali-G78", bgra, true)).red_blue_swapped);
    EXPECT_TRUE(gles::fastest_texel_format(context_named("llvmpipe (LLVM 15.0.6)", bgra, true)).red_blue_swapped);
    EXPECT_FALSE(gles::fastest_texel_format(context_named("llvmpipe (LLVM 15.0.6)", "", true)).red_blue_swapped);
    EXPECT_TRUE(gles::fastest_texel_format(context_named("llvmpipe (LLVM 15.0.6)", "", false)).red_blue_swapped);
}

} // namespace
} // namespace glint::test
