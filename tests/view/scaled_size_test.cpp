// Sizes of pictures that are shown larger than they are.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include <glint/governor.hpp>

namespace glint::test {
namespace {

TEST(ScaledSize, is_the_windows_own_at_full_scale) {
    EXPECT_EQ(scaled_size(1280, 720, 1.0f), (PictureSize{1280, 720}));
    EXPECT_EQ(scaled_size(1, 1, 1.0f), (PictureSize{1, 1}));
    EXPECT_EQ(scaled_size(1921, 1079, 2.0f), (PictureSize{1921, 1079}));
}

TEST(ScaledSize, keeps_the_windows_shape) {
    EXPECT_EQ(scaled_size(1280, 720, 0.5f), (PictureSize{640, 360}));
    EXPECT_EQ(scaled_size(1280, 720, 0.25f), (PictureSize{320, 180}));
    EXPECT_EQ(scaled_size(512, 512, 0.71f).width_px, scaled_size(512, 512, 0.71f).height_px);
    for (float scale = 0.25f; scale < 1.0f; scale += 0.013f) {
        const PictureSize size = scaled_size(1366, 768, scale);
        EXPECT_NEAR(size.height_px, size.width_px * 768.0 / 1366.0, 0.5);
        EXPECT_NEAR(size.width_px, 1366.0 * double(scale), 2.0);
    }
}

TEST(ScaledSize, is_the_same_for_scales_that_hardly_differ) {
    std::set<uint32_t> widths;
    for (int i = 0; i <= 75000; ++i) {
        widths.insert(scaled_size(1280, 720, 0.25f + 1e-5f * static_cast<float>(i)).width_px);
    }
    EXPECT_EQ(widths.size(), 241u); // 320 to 1280 in steps of 4
    for (const uint32_t width : widths) EXPECT_EQ(width % 4, 0u);
}

TEST(ScaledSize, is_at_least_a_pixel_and_at_most_the_window_whatever_is_asked) {
    const float scales[] = {0.0f,
                            -1.0f,
                            1e-30f,
                            0.25f,
                            0.999f,
                            std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()};
    for (const uint32_t width : {0u, 1u, 2u, 17u, 4096u, UINT32_MAX}) {
        for (const uint32_t height : {0u, 1u, 3u, 5000u, UINT32_MAX}) {
            for (const float scale : scales) {
                const PictureSize size = scaled_size(width, height, scale);
                EXPECT_GE(size.width_px, 1u);
                EXPECT_GE(size.height_px, 1u);
                EXPECT_LE(size.width_px, std::max(width, 1u));
                EXPECT_LE(size.height_px, std::max(height, 1u));
            }
        }
    }
}

} // namespace
} // namespace glint::test
