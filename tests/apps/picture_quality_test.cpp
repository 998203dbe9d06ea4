// Measures of pictures' likeness, against values worked out by hand.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "bench/picture_quality.hpp"

namespace glint::bench {
namespace {

std::vector<uint8_t> plain(size_t pixel_count, uint8_t value) {
    return std::vector<uint8_t>(4 * pixel_count, value);
}

TEST(PictureQuality, equal_pictures_are_as_near_as_can_be) {
    const std::vector<uint8_t> picture = plain(20 * 15, 77);
    EXPECT_EQ(psnr_db({picture, 20, 15}, {picture, 20, 15}), 99.0);
    EXPECT_DOUBLE_EQ(ssim({picture, 20, 15}, {picture, 20, 15}), 1.0);
}

TEST(PictureQuality, psnr_is_that_of_the_mean_square_error) {
    const std::vector<uint8_t> a = plain(100, 100);
    std::vector<uint8_t> b = plain(100, 110);
    EXPECT_NEAR(psnr_db({a, 10, 10}, {b, 10, 10}), 20.0 * std::log10(255.0 / 10.0), 1e-9);
    b = a;
    b[0] = 0; // one of 300 bytes, 100 off
    EXPECT_NEAR(psnr_db({a, 10, 10}, {b, 10, 10}), 10.0 * std::log10(255.0 * 255.0 * 300.0 / 10000.0), 1e-9);
    b[3] = 0; // alpha says nothing
    EXPECT_NEAR(psnr_db({a, 10, 10}, {b, 10, 10}), 10.0 * std::log10(255.0 * 255.0 * 300.0 / 10000.0), 1e-9);
}

TEST(PictureQuality, ssim_of_plain_pictures_compares_their_brightness) {
    const std::vector<uint8_t> a = plain(30 * 30, 100), b = plain(30 * 30, 50);
    const double c1 = 2.55 * 2.55;
    EXPECT_NEAR(ssim({a, 30, 30}, {b, 30, 30}), (2.0 * 100 * 50 + c1) / (100.0 * 100 + 50.0 * 50 + c1), 1e-9);
}

TEST(PictureQuality, ssim_of_a_picture_and_its_opposite_is_negative) {
    std::vector<uint8_t> a = plain(30 * 30, 128), b = a;
    for (size_t i = 0; i < a.size(); ++i) {
        const bool bright = (i / 4) % 2 == 0;
        a[i] = bright ? 228 : 28;
        b[i] = bright ? 28 : 228;
    }
    EXPECT_LT(ssim({a, 30, 30}, {b, 30, 30}), -0.9);
}

TEST(PictureQuality, pictures_smaller_than_the_window_are_one_window) {
    const std::vector<uint8_t> a = plain(3 * 2, 10), b = plain(3 * 2, 200);
    EXPECT_DOUBLE_EQ(ssim({a, 3, 2}, {a, 3, 2}), 1.0);
    EXPECT_LT(ssim({a, 3, 2}, {b, 3, 2}), 0.2);
}

} // namespace
} // namespace glint::bench
