// Rectangles land where they should, mix as light does, and leave everything else alone.
#include <gtest/gtest.h>

#include "viewer/hud/canvas.hpp"
#include "viewer/hud/pixels.hpp"

namespace glint::test {
namespace {

using viewer::Canvas;
using viewer::Rectangle;
using viewer::Rgba;

TEST(Canvas, fills_the_pixels_of_a_rectangle_and_no_others) {
    Pixels pixels(7, 5);
    const Canvas canvas = pixels.canvas();
    canvas.clear();
    canvas.fill({2, 1, 5, 4}, {10, 20, 30, 40});
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 7; ++x) {
            const bool inside = x >= 2 && x < 5 && y >= 1 && y < 4;
            EXPECT_EQ(canvas.at(x, y), inside ? Rgba(10, 20, 30, 40) : Rgba(0, 0, 0, 0)) << x << ' ' << y;
        }
    }
    EXPECT_TRUE(pixels.is_untouched_outside());
}

TEST(Canvas, clips_at_every_edge) {
    Pixels pixels(4, 3);
    const Canvas canvas = pixels.canvas();
    for (const Rectangle &area : {Rectangle{-9, -9, 99, 99}, Rectangle{-2, 1, 1, 2}, Rectangle{3, -5, 8, 9},
                                  Rectangle{4, 0, 9, 3}, Rectangle{0, 3, 4, 9}, Rectangle{-9, 0, 0, 3},
                                  Rectangle{3, 2, 1, 0}, Rectangle{-2000000000, -2000000000, 2000000000, 2000000000}}) {
        canvas.fill(area, {1, 2, 3, 255});
        EXPECT_TRUE(pixels.is_untouched_outside());
    }
    EXPECT_EQ(canvas.at(0, 0), Rgba(1, 2, 3, 255));
    EXPECT_EQ(canvas.at(3, 2), Rgba(1, 2, 3, 255));
}

// Blending two layers over a picture one after the other, or first with each other, is the same.
TEST(Canvas, mixes_straight_alpha_as_if_the_layers_were_blended_one_by_one) {
    const auto blended = [](double under, double color, double alpha) { return under + (color - under) * alpha; };
    for (const int lower_alpha : {0, 1, 60, 128, 254, 255}) {
        for (const int upper_alpha : {0, 1, 60, 128, 254, 255}) {
            Pixels pixels(1, 1);
            const Canvas canvas = pixels.canvas();
            canvas.clear();
            canvas.fill({0, 0, 1, 1}, {200, 10, 0, static_cast<uint8_t>(lower_alpha)});
            canvas.fill({0, 0, 1, 1}, {50, 255, 90, static_cast<uint8_t>(upper_alpha)});
            const Rgba mixed = canvas.at(0, 0);
            for (const double picture : {0.0, 100.0, 255.0}) {
                const double expected = blended(blended(picture, 200, lower_alpha / 255.0), 50, upper_alpha / 255.0);
                EXPECT_NEAR(blended(picture, mixed.r, mixed.a / 255.0), expected, 1.0)
                    << lower_alpha << ' ' << upper_alpha;
            }
        }
    }
}

TEST(Rectangle, is_cut_and_joined) {
    EXPECT_EQ(Rectangle({0, 0, 5, 5}).within({3, -2, 9, 4}), Rectangle({3, 0, 5, 4}));
    EXPECT_TRUE(Rectangle({0, 0, 5, 5}).within({5, 0, 9, 9}).empty());
    EXPECT_EQ(Rectangle({0, 0, 2, 2}).with({4, 5, 6, 7}), Rectangle({0, 0, 6, 7}));
    EXPECT_EQ(Rectangle({0, 0, 0, 0}).with({4, 5, 6, 7}), Rectangle({4, 5, 6, 7}));
    EXPECT_EQ(Rectangle({4, 5, 6, 7}).with({9, 9, 9, 9}), Rectangle({4, 5, 6, 7}));
}

} // namespace
} // namespace glint::test
