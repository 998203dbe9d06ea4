// The display shows what it is given, in every size of window, and draws on nothing else.
#include "viewer/hud/hud.hpp"

#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glint/ray_tree.hpp>

#include "viewer/hud/pixels.hpp"
#include "viewer/hud/text.hpp"

namespace glint::test {
namespace {

using viewer::Canvas;
using viewer::draw_hud;
using viewer::Glyph;
using viewer::HudContent;
using viewer::HudKey;
using viewer::Rectangle;
using viewer::Rgba;

const std::vector<HudKey> keys = {{"left drag", "orbit"}, {"H", "this page"}};

HudContent figures() {
    HudContent content;
    content.figures.render_ms = 1.67;
    content.figures.fps = 559.4;
    content.figures.mrays_per_s = 312.0;
    content.figures.isa = "avx512";
    content.figures.width_px = 640;
    content.figures.height_px = 480;
    return content;
}

/// A primary ray that meets a mirror, a shadow ray that something blocks, and a mirrored one into the void.
RayTree some_tree() {
    RayTree tree;
    tree.x = 12;
    tree.y = 34;
    tree.rays.resize(3);
    tree.rays[0].target = RayTarget::object;
    tree.rays[0].target_name = "cube";
    tree.rays[0].distance = 2.5f;
    tree.rays[1].kind = RayKind::shadow;
    tree.rays[1].parent = 0;
    tree.rays[1].level = 1;
    tree.rays[1].light = 0;
    tree.rays[1].light_name = "lamp";
    tree.rays[1].target = RayTarget::object;
    tree.rays[1].target_name = "wall";
    tree.rays[2].kind = RayKind::mirror;
    tree.rays[2].parent = 0;
    tree.rays[2].level = 1;
    tree.rays[2].distance = std::numeric_limits<float>::infinity();
    tree.rays[2].weight = 0.5f;
    tree.rays[2].contribution = Color(0.5f, 0.0f, 0.0f);
    return tree;
}

/// Whether the text stands on the canvas in any one colour: each pixel of its letters has the colour, no other has.
bool shows(const Canvas &canvas, const std::string &text, int scale = 1) {
    const Rectangle all = canvas.bounds();
    const int columns = static_cast<int>(text.size()) * Glyph::advance_px - 1;
    const auto is_at = [&](int x0, int y0) {
        int ink_x = 0;
        while (!Glyph(text[0]).has_ink(ink_x % Glyph::width_px, ink_x / Glyph::width_px)) ++ink_x;
        const Rgba ink = canvas.at(x0 + ink_x % Glyph::width_px * scale, y0 + ink_x / Glyph::width_px * scale);
        if (ink.a != 255) return false;
        for (int y = 0; y < Glyph::height_px; ++y) {
            for (int x = 0; x < columns; ++x) {
                const char letter = text[static_cast<size_t>(x / Glyph::advance_px)];
                const int within = x % Glyph::advance_px;
                const bool has_ink = within < Glyph::width_px && Glyph(letter).has_ink(within, y);
                if ((canvas.at(x0 + x * scale, y0 + y * scale) == ink) != has_ink) return false;
            }
        }
        return true;
    };
    for (int y = 0; y + Glyph::height_px * scale <= all.y1; ++y) {
        for (int x = 0; x + columns * scale <= all.x1; ++x) {
            if (is_at(x, y)) return true;
        }
    }
    return false;
}

TEST(Hud, shows_every_figure) {
    HudContent content = figures();
    content.figures.upload_ms = 12.3;
    content.figures.gl_ms = 0.456;
    content.figures.depth = 7;
    content.figures.scale = 0.71f;
    content.figures.threads = 3;
    content.figures.samples = 16;
    content.figures.is_paused = true;
    content.target_ms = 1000.0f / 60.0f;
    for (const int scale : {1, 2}) {
        Pixels pixels(400, 300);
        const Canvas canvas = pixels.canvas();
        (void)draw_hud(canvas, content, static_cast<uint32_t>(scale));
        for (const char *words : {"559 fps", "of 60", "1.67 ms", "12.3 ms", "0.46 ms", "312 M/s", "640x480", "71%",
                                  "depth 7", "16 samples", "3 threads", "avx512", "paused"}) {
            EXPECT_TRUE(shows(canvas, words, scale)) << words << " scale " << scale;
        }
        EXPECT_FALSE(shows(canvas, "560 fps", scale));
    }
}

TEST(Hud, shows_the_rays_indented_below_those_that_sent_them) {
    Pixels pixels(640, 480);
    const Canvas canvas = pixels.canvas();
    HudContent content = figures();
    const RayTree tree = some_tree();
    content.ray_tree = &tree;
    (void)draw_hud(canvas, content);
    for (const char *words : {"pixel 12,34", "3 rays", "100.0%     2.5", "eye: cube (0)", "50.0%       -",
                              "no lamp (0): wall (0)", "mirrored: background"}) {
        EXPECT_TRUE(shows(canvas, words)) << words;
    }
}

TEST(Hud, shows_a_long_list_page_by_page) {
    RayTree tree = some_tree();
    for (int i = 0; i < 500; ++i) {
        tree.rays.push_back(tree.rays[2]);
        tree.rays.back().target = RayTarget::object;
        tree.rays.back().target_name = "pane" + std::to_string(i);
    }
    HudContent content = figures();
    content.ray_tree = &tree;
    Pixels pixels(640, 200);
    (void)draw_hud(pixels.canvas(), content);
    EXPECT_TRUE(shows(pixels.canvas(), "eye: cube"));
    EXPECT_TRUE(shows(pixels.canvas(), "more"));
    EXPECT_FALSE(shows(pixels.canvas(), "pane499"));
    content.first_ray = 103;
    (void)draw_hud(pixels.canvas(), content);
    EXPECT_FALSE(shows(pixels.canvas(), "eye: cube"));
    EXPECT_TRUE(shows(pixels.canvas(), "mirrored: pane100"));
    content.first_ray = UINT32_MAX;
    (void)draw_hud(pixels.canvas(), content);
    EXPECT_TRUE(shows(pixels.canvas(), "mirrored: pane499"));
    EXPECT_FALSE(shows(pixels.canvas(), "more"));
}

TEST(Hud, shows_help_and_message) {
    Pixels pixels(640, 480);
    HudContent content;
    content.shows_figures = false;
    content.help = keys;
    content.message = "saved shot.png";
    const Rectangle drawn = draw_hud(pixels.canvas(), content);
    for (const char *words : {"left drag", "orbit", "H", "this page", "saved shot.png"}) {
        EXPECT_TRUE(shows(pixels.canvas(), words)) << words;
    }
    EXPECT_FALSE(shows(pixels.canvas(), "fps"));
    EXPECT_GT(drawn.y0, 100);
}

TEST(Hud, that_shows_nothing_is_transparent) {
    Pixels pixels(64, 48);
    const Canvas canvas = pixels.canvas();
    HudContent content;
    content.shows_figures = false;
    EXPECT_TRUE(draw_hud(canvas, content).empty());
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) ASSERT_EQ(canvas.at(x, y), Rgba(0, 0, 0, 0));
    }
}

TEST(Hud, tells_which_part_of_the_canvas_it_drew_on) {
    std::vector<float> times(120, 10.0f);
    HudContent content = figures();
    content.frame_times_ms = times;
    Pixels pixels(640, 480);
    const Canvas canvas = pixels.canvas();
    const Rectangle drawn = draw_hud(canvas, content);
    EXPECT_LT(drawn.x1, 200);
    EXPECT_LT(drawn.y1, 200);
    bool touches_left = false, touches_lower = false;
    for (int y = 0; y < 480; ++y) {
        for (int x = 0; x < 640; ++x) {
            if (canvas.at(x, y).a == 0) continue;
            ASSERT_TRUE(x >= drawn.x0 && x < drawn.x1 && y >= drawn.y0 && y < drawn.y1) << x << ' ' << y;
            touches_left = touches_left || x == drawn.x0;
            touches_lower = touches_lower || y == drawn.y1 - 1;
        }
    }
    EXPECT_TRUE(touches_left && touches_lower);
}

TEST(Hud, has_a_bar_for_each_of_the_last_120_frames) {
    std::vector<float> times(500, 30.0f);
    for (size_t i = 380; i < 500; ++i) times[i] = 20.0f;
    HudContent content = figures();
    content.frame_times_ms = times;
    Pixels pixels(400, 300);
    const Canvas canvas = pixels.canvas();
    const Rectangle drawn = draw_hud(canvas, content);
    const int lowest = drawn.y1 - 7; // above the margin
    int bars = 0;
    for (int x = 0; x < 400; ++x) {
        if (canvas.at(x, lowest).a != 255) continue;
        ++bars;
        int height = 0;
        while (canvas.at(x, lowest - height).a == 255) ++height;
        EXPECT_NEAR(height, 36 * 20.0 / 33.333, 1.0);
    }
    EXPECT_EQ(bars, 120);
}

TEST(Hud, is_drawn_in_every_size_of_window_and_never_beside_it) {
    std::mt19937 random(7);
    const auto up_to = [&](uint32_t most) { return std::uniform_int_distribution<uint32_t>(0, most)(random); };
    std::vector<float> times(130, 12.0f);
    RayTree tree = some_tree();
    for (int i = 0; i < 40; ++i) {
        tree.rays.push_back(tree.rays[2]);
        tree.rays.back().level = up_to(1) == 0 ? up_to(30) : UINT32_MAX;
        tree.rays.back().target_name = std::string(up_to(90), 'x');
        tree.rays.back().weight = 0.0f;
    }
    for (int run = 0; run < 2000; ++run) {
        // Small ones most of all.
        const uint32_t most = run % 4 == 0 ? 700 : run % 4 == 1 ? 200 : 40;
        const uint32_t width = run < 9 ? 1 + static_cast<uint32_t>(run) / 3 : 1 + up_to(most);
        const uint32_t height = run < 9 ? 1 + static_cast<uint32_t>(run) % 3 : 1 + up_to(most);
        HudContent content = figures();
        content.shows_figures = up_to(3) > 0;
        content.figures.isa = std::string(up_to(40), 'w');
        content.figures.render_ms = up_to(5) == 0 ? 1e300 : -std::numeric_limits<double>::infinity();
        content.figures.is_paused = up_to(1) == 0;
        content.frame_times_ms = std::span(times).first(up_to(130));
        content.target_ms = up_to(2) == 0 ? 16.7f : 0.0f;
        if (up_to(1) == 0) content.help = keys;
        if (up_to(1) == 0) content.ray_tree = &tree;
        content.first_ray = up_to(60);
        content.message = std::string(up_to(60), 'm');
        Pixels pixels(width, height, up_to(5));
        const Rectangle drawn = draw_hud(pixels.canvas(), content, up_to(7) == 0 ? UINT32_MAX : up_to(4));
        ASSERT_TRUE(pixels.is_untouched_outside()) << width << 'x' << height << " run " << run;
        ASSERT_TRUE(drawn.empty() || (drawn.x0 >= 0 && drawn.y0 >= 0 && drawn.x1 <= static_cast<int>(width) &&
                                      drawn.y1 <= static_cast<int>(height)));
    }
}

} // namespace
} // namespace glint::test
