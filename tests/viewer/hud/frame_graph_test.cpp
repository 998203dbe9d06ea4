// Each bar of the graph is as high as its frame was long.
#include "viewer/hud/frame_graph.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "viewer/hud/pixels.hpp"

namespace glint::test {
namespace {

using viewer::Canvas;
using viewer::Rgba;

/// Pixels of a column that are drawn on, from the lower edge up to the first that is not.
int filled(const Canvas &canvas, int x) {
    int height = 0;
    for (int y = canvas.bounds().y1 - 1; y >= 0 && canvas.at(x, y).a > 0; --y) ++height;
    return height;
}

TEST(FrameGraph, has_bars_as_high_as_the_times) {
    std::vector<float> times;
    for (int i = 0; i < 60; ++i) times.push_back(static_cast<float>(i) * 0.5f);
    for (const int scale : {1, 2}) {
        Pixels pixels(60 * static_cast<uint32_t>(scale), 50);
        const Canvas canvas = pixels.canvas();
        canvas.clear();
        viewer::draw_frame_graph(canvas, canvas.bounds(), times, 0.0f, scale);
        // The upper edge is 33 1/3 ms, 50 pixels: 1.5 pixels a millisecond.
        for (int x = 0; x < 60 * scale; ++x) {
            const float exact = times[static_cast<size_t>(x / scale)] * 1.5f;
            EXPECT_NEAR(static_cast<float>(filled(canvas, x)), exact, exact > 0.0f ? 1.0f : 0.0f) << x;
        }
    }
}

TEST(FrameGraph, shows_the_newest_at_the_right_edge_and_what_there_is_room_for) {
    const std::vector<float> times = {30, 30, 30, 10, 20};
    Pixels pixels(3, 100);
    const Canvas canvas = pixels.canvas();
    canvas.clear();
    viewer::draw_frame_graph(canvas, canvas.bounds(), times, 0.0f, 1);
    EXPECT_EQ(filled(canvas, 0), 90);
    EXPECT_EQ(filled(canvas, 1), 30);
    EXPECT_EQ(filled(canvas, 2), 60);

    Pixels wide(8, 100);
    const Canvas wider = wide.canvas();
    wider.clear();
    viewer::draw_frame_graph(wider, wider.bounds(), times, 0.0f, 1);
    EXPECT_EQ(filled(wider, 2), 0);
    EXPECT_EQ(filled(wider, 3), 90);
    EXPECT_EQ(filled(wider, 7), 60);
}

TEST(FrameGraph, draws_the_target_line_at_its_height) {
    Pixels pixels(10, 40);
    const Canvas canvas = pixels.canvas();
    canvas.clear();
    viewer::draw_frame_graph(canvas, canvas.bounds(), {}, 20.0f, 1);
    // The upper edge is 40 ms.
    for (int x = 0; x < 10; ++x) {
        for (int y = 0; y < 40; ++y) EXPECT_EQ(canvas.at(x, y).a > 0, y == 20) << x << ' ' << y;
    }
}

TEST(FrameGraph, tells_slow_frames_by_their_colour) {
    const std::vector<float> times = {10, 19, 25, 25, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 100};
    Pixels pixels(16, 40);
    const Canvas canvas = pixels.canvas();
    canvas.clear();
    viewer::draw_frame_graph(canvas, canvas.bounds(), times, 20.0f, 1);
    const Rgba good = canvas.at(0, 39), slow = canvas.at(2, 39), bad = canvas.at(15, 39);
    EXPECT_EQ(canvas.at(1, 39), good);
    EXPECT_NE(slow, good);
    EXPECT_NE(bad, good);
    EXPECT_NE(bad, slow);
}

TEST(FrameGraph, is_not_flattened_by_one_slow_frame_but_fits_many) {
    std::vector<float> times(120, 10.0f);
    EXPECT_FLOAT_EQ(viewer::graph_top_ms(times, 16.0f), 32.0f);
    times[50] = 500.0f;
    EXPECT_FLOAT_EQ(viewer::graph_top_ms(times, 16.0f), 32.0f);
    for (size_t i = 0; i < 20; ++i) times[i] = 100.0f;
    EXPECT_FLOAT_EQ(viewer::graph_top_ms(times, 16.0f), 128.0f);
    EXPECT_FLOAT_EQ(viewer::graph_top_ms({}, 0.0f), 100.0f / 3.0f);
}

TEST(FrameGraph, bears_times_that_are_none) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(viewer::bar_height(nan, 33.0f, 40), 0);
    EXPECT_EQ(viewer::bar_height(-1.0f, 33.0f, 40), 0);
    EXPECT_EQ(viewer::bar_height(0.0f, 33.0f, 40), 0);
    EXPECT_EQ(viewer::bar_height(1e-20f, 33.0f, 40), 1);
    EXPECT_EQ(viewer::bar_height(inf, 33.0f, 40), 40);
    const std::vector<float> times = {nan, inf, -inf, 1e30f, inf, inf};
    Pixels pixels(6, 5);
    for (const float target : {0.0f, nan, inf, -1.0f, 1e-30f, 1e30f}) {
        viewer::draw_frame_graph(pixels.canvas(), pixels.canvas().bounds(), times, target, 1);
        EXPECT_TRUE(std::isfinite(viewer::graph_top_ms(times, target)));
    }
    EXPECT_TRUE(pixels.is_untouched_outside());
}

} // namespace
} // namespace glint::test
