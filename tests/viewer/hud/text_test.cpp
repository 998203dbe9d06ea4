// Text lands where it should, letter by letter.
#include "viewer/hud/text.hpp"

#include <gtest/gtest.h>

#include "viewer/hud/pixels.hpp"

namespace glint::test {
namespace {

using viewer::Canvas;
using viewer::Glyph;
using viewer::Rgba;

constexpr Rgba white{255, 255, 255, 255}, nothing{0, 0, 0, 0};

TEST(Text, puts_every_pixel_of_every_letter_in_its_place) {
    for (const int scale : {1, 2, 3}) {
        Pixels pixels(80, 60);
        const Canvas canvas = pixels.canvas();
        canvas.clear();
        const std::string text = "gQ{";
        viewer::draw_text(canvas, 4, 7, text, white, scale);
        for (int y = 0; y < 60; ++y) {
            for (int x = 0; x < 80; ++x) {
                const int column = x < 4 ? -1 : (x - 4) / scale, row = y < 7 ? -1 : (y - 7) / scale;
                const int letter = column / Glyph::advance_px, within = column % Glyph::advance_px;
                const bool is_letter =
                    column >= 0 && row >= 0 && letter < 3 && within < Glyph::width_px && row < Glyph::height_px;
                const bool has_ink = is_letter && Glyph(text[static_cast<size_t>(letter)]).has_ink(within, row);
                ASSERT_EQ(canvas.at(x, y), has_ink ? white : nothing) << x << ' ' << y << " scale " << scale;
            }
        }
    }
}

TEST(Text, is_clipped_at_every_edge) {
    Pixels pixels(9, 8);
    const Canvas canvas = pixels.canvas();
    for (int y = -20; y < 20; ++y) {
        for (int x = -40; x < 20; ++x) viewer::draw_text(canvas, x, y, "glint {}", white, 2);
    }
    EXPECT_TRUE(pixels.is_untouched_outside());
}

TEST(Text, that_is_too_long_is_cut) {
    EXPECT_EQ(viewer::cut_to("cornell", 7), "cornell");
    EXPECT_EQ(viewer::cut_to("cornell", 6), "corn..");
    EXPECT_EQ(viewer::cut_to("cornell", 2), "..");
    EXPECT_EQ(viewer::cut_to("cornell", 1), ".");
    EXPECT_EQ(viewer::cut_to("cornell", 0), "");
    EXPECT_EQ(viewer::cut_to("cornell", -3), "");
    EXPECT_EQ(viewer::cut_to("", 0), "");
}

TEST(Text, counts_characters_of_utf8_not_bytes) {
    EXPECT_EQ(viewer::columns_of("k\xc3\xbchl"), 4);
    EXPECT_EQ(viewer::cut_to("k\xc3\xbchl", 4), "k\xc3\xbchl");
    EXPECT_EQ(viewer::cut_to("k\xc3\xbchler Raum", 5), "k\xc3\xbch..");
}

} // namespace
} // namespace glint::test
