// The picture's memory, its hashes, and the way to eight bits.
#include <cmath>

#include <glint/framebuffer.hpp>
#include <gtest/gtest.h>

#include "image/resolve.hpp"

namespace glint::test {
namespace {

TEST(Resolve, is_round_of_255_times_the_clamped_channel) {
    for (int i = -1000; i <= 300'000; ++i) {
        const float c = static_cast<float>(i) / 200'000.0f;
        const float clamped = std::fmin(std::fmax(c, 0.0f), 1.0f);
        ASSERT_EQ(resolve_channel(c), static_cast<uint8_t>(std::round(255.0f * clamped))) << c;
    }
    EXPECT_EQ(resolve_channel(std::nextafter(0.5f / 255.0f, 0.0f)), 0);
    EXPECT_EQ(resolve_channel(NAN), 0);
    EXPECT_EQ(resolve_channel(INFINITY), 255);
    EXPECT_EQ(resolve_channel(-INFINITY), 0);
}

TEST(FramebufferMemory, begins_as_zeroes) {
    const auto framebuffer = Framebuffer::create(3, 2);
    ASSERT_TRUE(framebuffer);
    for (int i = 0; i < 3 * 2 * 4; ++i) EXPECT_EQ(framebuffer->rgba8()[i], 0);
    for (int i = 0; i < 3 * 2 * 3; ++i) EXPECT_EQ(framebuffer->radiance()[i], 0.0f);
    EXPECT_EQ(framebuffer->rgba8_stride_bytes(), 12u);
}

TEST(FramebufferMemory, can_do_without_radiance) {
    const auto framebuffer = Framebuffer::create(3, 2, false);
    ASSERT_TRUE(framebuffer);
    EXPECT_FALSE(framebuffer->has_radiance());
    EXPECT_EQ(framebuffer->radiance(), nullptr);
}

TEST(FramebufferMemory, refuses_sizes_that_make_no_sense) {
    EXPECT_EQ(Framebuffer::create(0, 5).error().code, ErrorCode::bad_input);
    EXPECT_EQ(Framebuffer::create(5, 0).error().code, ErrorCode::bad_input);
    const auto huge = Framebuffer::create(UINT32_MAX, UINT32_MAX);
    ASSERT_FALSE(huge);
    EXPECT_EQ(huge.error().code, ErrorCode::limit_exceeded);
    EXPECT_NE(huge.error().text().find("4294967295 x 4294967295"), std::string::npos);
}

TEST(PictureHash, is_xxh3_of_the_bytes) {
    auto framebuffer = Framebuffer::create(1, 1);
    ASSERT_TRUE(framebuffer);
    // Reference values: XXH3-64 of four and of twelve zero bytes, by the xxhash package for Python.
    EXPECT_EQ(framebuffer->pixel_hash(), 0x48b2c92616fc193dull);
    EXPECT_EQ(framebuffer->radiance_hash(), 0xc4998f9169c2a4f0ull);
    const uint64_t before = framebuffer->pixel_hash();
    framebuffer->rgba8()[3] = 1;
    EXPECT_NE(framebuffer->pixel_hash(), before);
}

} // namespace
} // namespace glint::test
