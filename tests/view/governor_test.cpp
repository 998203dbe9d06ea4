// The governor on loads that are made up: no test here looks at a clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>

#include <glint/governor.hpp>

#include "support/random.hpp"

namespace glint::test {
namespace {

/// What tracing at full scale takes, in seconds, at a time and a depth.
using Load = std::function<double(double seconds, uint32_t depth)>;

struct Costs {
    Load load;
    double constant_s = 0.002; ///< of tracing, whatever the scale
    double rest_s = 0.0005;    ///< beside tracing and presenting
    double noise = 0.0;        ///< largest share that a frame's time is off
    unsigned frames_in_flight = 2;
    bool waits = false; ///< whether the loop waits for its next turn when it is early
};

/// Everything that happened from some moment on.
struct History {
    unsigned frames = 0, scale_changes = 0, depth_changes = 0;
    double seconds = 0.0;
    double slowest_second_fps = 1e9, fastest_second_fps = 0.0;
    float least_scale = 2.0f, greatest_scale = 0.0f;
    [[nodiscard]] double fps() const { return frames / seconds; }
};

/// A loop of frames in made-up time.
class Loop {
public:
    Loop(const GovernorOptions &options, Costs costs)
        : governor(Governor::create(options).value()), costs_(std::move(costs)), target_s_(1.0 / options.target_fps) {}

    void frame() {
        in_flight_.push_back(governor.quality());
        if (in_flight_.size() < costs_.frames_in_flight) return;
        const FrameQuality quality = in_flight_.front();
        in_flight_.pop_front();
        const double off = 1.0 + costs_.noise * double(random_.uniform(-1.0f, 1.0f));
        const double scale = double(quality.scale);
        FrameTimes times;
        times.render_s = off * (costs_.load(now_s, quality.depth) * scale * scale + costs_.constant_s) + spike_s;
        times.present_s = 0.003;
        times.frame_s = std::max(times.render_s, times.present_s) + costs_.rest_s;
        if (costs_.waits && times.frame_s < target_s_) {
            times.wait_s = target_s_ - times.frame_s;
            times.frame_s = target_s_;
        }
        now_s += times.frame_s;
        governor.measured(quality, times);
    }

    void frames(unsigned count) {
        for (unsigned i = 0; i < count; ++i) frame();
    }

    History run(double seconds) {
        History history;
        const double start_s = now_s;
        double second_began_s = now_s;
        unsigned frames_of_second = 0;
        while (now_s - start_s < seconds) {
            const FrameQuality before = governor.quality();
            frame();
            const FrameQuality after = governor.quality();
            ++history.frames;
            history.scale_changes += after.scale != before.scale ? 1 : 0;
            history.depth_changes += after.depth != before.depth ? 1 : 0;
            history.least_scale = std::min(history.least_scale, after.scale);
            history.greatest_scale = std::max(history.greatest_scale, after.scale);
            ++frames_of_second;
            if (now_s - second_began_s >= 1.0) {
                const double fps = frames_of_second / (now_s - second_began_s);
                history.slowest_second_fps = std::min(history.slowest_second_fps, fps);
                history.fastest_second_fps = std::max(history.fastest_second_fps, fps);
                frames_of_second = 0;
                second_began_s = now_s;
            }
        }
        history.seconds = now_s - start_s;
        return history;
    }

    Governor governor;
    double now_s = 0.0;
    double spike_s = 0.0; ///< more, of the frames from now on

private:
    Costs costs_;
    double target_s_;
    std::deque<FrameQuality> in_flight_;
    Random random_{7};
};

const GovernorOptions at_30{.target_fps = 30.0, .least_scale = 0.25f, .least_depth = 0, .greatest_depth = 3};

Load constant(double seconds) {
    return [=](double, uint32_t) { return seconds; };
}

/// Goes up and down by a share of itself, as on a flight through a scene.
Load waves(double mean_s, double share, double period_s) {
    return [=](double now_s, uint32_t) { return mean_s * (1.0 + share * std::sin(now_s * 6.283185 / period_s)); };
}

TEST(Governor, refuses_options_that_make_no_sense) {
    const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double fps : {0.0, -0.0, -30.0, nan, infinite, -infinite, 1000.1}) {
        const auto governor = Governor::create({.target_fps = fps});
        ASSERT_FALSE(governor.ok()) << fps;
        EXPECT_EQ(governor.error().code, ErrorCode::bad_input);
        EXPECT_NE(governor.error().text().find("frame rate"), std::string::npos) << governor.error().text();
    }
    for (const float scale : {0.0f, -0.5f, 1.01f, std::numeric_limits<float>::quiet_NaN()}) {
        EXPECT_FALSE(Governor::create({.least_scale = scale}).ok()) << scale;
    }
    EXPECT_FALSE(Governor::create({.least_depth = 3, .greatest_depth = 2}).ok());
    EXPECT_TRUE(Governor::create({.target_fps = 1000.0, .least_scale = 1.0f}).ok());
}

TEST(Governor, leaves_a_picture_alone_that_is_quick_enough) {
    Loop loop(at_30, {.load = constant(0.02), .noise = 0.1});
    const History history = loop.run(20.0);
    EXPECT_EQ(loop.governor.quality(), (FrameQuality{1.0f, 3}));
    EXPECT_EQ(history.scale_changes + history.depth_changes, 0u);
}

TEST(Governor, reaches_the_target_within_a_few_frames_of_a_step_of_load) {
    double load_s = 0.02;
    Loop loop(at_30, {.load = [&](double, uint32_t) { return load_s; }, .noise = 0.03});
    loop.frames(100);
    const auto frames_until_on_target = [&](double from_s) {
        load_s = from_s;
        for (unsigned frames = 1; frames < 100; ++frames) {
            loop.frame();
            const double scale = double(loop.governor.quality().scale);
            const double frame_s = load_s * scale * scale + 0.0025;
            if (frame_s * 30.0 < 1.1 && frame_s * 30.0 > 0.9) return frames;
        }
        return 100u;
    };
    EXPECT_LE(frames_until_on_target(0.1), 4u) << "up, by five";
    loop.frames(30);
    EXPECT_LE(frames_until_on_target(0.3), 4u) << "up, by three";
    loop.frames(30);
    // What does not shrink with the scale does not grow with it either: a second step, of the mean, finds the rest.
    EXPECT_LE(frames_until_on_target(0.05), 10u) << "down, by six";
    EXPECT_EQ(loop.governor.quality().depth, 3u);
}

TEST(Governor, does_not_move_for_a_single_slow_frame) {
    Loop loop(at_30, {.load = constant(0.1), .noise = 0.03});
    loop.frames(60);
    const FrameQuality before = loop.governor.quality();
    for (int spike = 0; spike < 20; ++spike) {
        loop.spike_s = 0.2;
        loop.frame();
        loop.spike_s = 0.0;
        loop.frames(20);
    }
    EXPECT_NEAR(loop.governor.quality().scale, before.scale, 0.02f);
    EXPECT_EQ(loop.governor.quality().depth, before.depth);
}

TEST(Governor, holds_the_rate_and_hardly_moves_under_a_steady_load_whatever_the_noise) {
    for (const double noise : {0.0, 0.03, 0.1, 0.17}) {
        for (const unsigned in_flight : {1u, 2u, 3u}) {
            for (const bool waits : {false, true}) {
                Loop loop(at_30,
                          {.load = constant(0.1), .noise = noise, .frames_in_flight = in_flight, .waits = waits});
                loop.run(2.0);
                const History history = loop.run(300.0);
                const auto which = ::testing::Message() << noise << ' ' << in_flight << ' ' << waits;
                EXPECT_LT(history.scale_changes / history.seconds, 0.5) << which;
                EXPECT_EQ(history.depth_changes, 0u) << which;
                EXPECT_NEAR(history.fps(), 30.0, 1.5) << which;
                // So that the numbers above are about a governor that had something to do.
                EXPECT_GT(history.least_scale, 0.4f) << which;
                EXPECT_LT(history.greatest_scale, 0.7f) << which;
                if (noise == 0.0) {
                    EXPECT_EQ(history.scale_changes, 0u);
                }
            }
        }
    }
}

TEST(Governor, holds_30_within_2_through_a_minute_of_flight) {
    for (const double noise : {0.0, 0.05}) {
        for (const bool waits : {false, true}) {
            Loop loop(at_30, {.load = waves(0.12, 0.4, 20.0), .noise = noise, .waits = waits});
            loop.run(2.0);
            const History history = loop.run(60.0);
            EXPECT_NEAR(history.fps(), 30.0, 1.0);
            EXPECT_GE(history.slowest_second_fps, 28.0);
            EXPECT_LE(history.fastest_second_fps, 32.5);
            EXPECT_GE(history.least_scale, 0.25f);
            EXPECT_GT(history.greatest_scale - history.least_scale, 0.15f) << "the load did vary";
        }
    }
}

TEST(Governor, follows_a_ramp) {
    Loop loop(at_30, {.load = [](double now_s, uint32_t) { return 0.05 * std::pow(1.1, now_s); }, .noise = 0.05});
    loop.run(2.0);
    const History history = loop.run(20.0); // to a load of seven times as much
    EXPECT_NEAR(history.fps(), 30.0, 1.5);
    EXPECT_GE(history.slowest_second_fps, 28.0);
    EXPECT_EQ(history.depth_changes, 0u);
}

TEST(Governor, takes_depth_only_when_there_is_no_more_scale_to_take) {
    Loop loop(at_30, {.load = [](double, uint32_t depth) { return 0.35 * (1.0 + depth); }, .noise = 0.05});
    uint32_t depth = 3;
    for (int i = 0; i < 300; ++i) {
        const FrameQuality before = loop.governor.quality();
        loop.frame();
        const FrameQuality after = loop.governor.quality();
        if (after.depth < before.depth) {
            EXPECT_EQ(before.scale, at_30.least_scale);
        }
        EXPECT_GE(after.scale, at_30.least_scale);
        depth = std::min(depth, after.depth);
    }
    EXPECT_EQ(depth, 0u); // 0.7 s a 16th is too much at depth 1
    const History history = loop.run(120.0);
    EXPECT_EQ(history.depth_changes, 0u) << "and it does not try again and again";
    EXPECT_NEAR(history.fps(), 30.0, 1.5);
}

TEST(Governor, gives_depth_back_before_scale) {
    double load_s = 0.5;
    Loop loop(at_30, {.load = [&](double, uint32_t depth) { return load_s * (1.0 + depth); }, .noise = 0.05});
    loop.frames(300);
    ASSERT_EQ(loop.governor.quality().depth, 0u);
    load_s = 0.05;
    uint32_t depth = 0;
    for (int i = 0; i < 200; ++i) {
        loop.frame();
        EXPECT_GE(loop.governor.quality().depth, depth) << "one way";
        depth = loop.governor.quality().depth;
    }
    EXPECT_EQ(depth, 3u);
    const History history = loop.run(20.0);
    EXPECT_NEAR(history.fps(), 30.0, 1.5);
    EXPECT_EQ(history.depth_changes, 0u);
}

TEST(Governor, stops_at_the_least_of_everything) {
    Loop loop(at_30, {.load = constant(100.0)});
    loop.frames(100);
    EXPECT_EQ(loop.governor.quality(), (FrameQuality{0.25f, 0}));
    loop.frames(100);
    EXPECT_EQ(loop.governor.quality(), (FrameQuality{0.25f, 0}));
}

TEST(Governor, does_not_take_scale_for_presenting_that_is_too_slow_by_itself) {
    Governor governor = Governor::create(at_30).value();
    for (int i = 0; i < 200; ++i) {
        governor.measured(governor.quality(), {.render_s = 0.02, .present_s = 0.05, .frame_s = 0.05});
    }
    EXPECT_EQ(governor.quality(), (FrameQuality{1.0f, 3}));
    // In a loop that does one after the other there is less time for tracing.
    for (int i = 0; i < 200; ++i) {
        const double scale = double(governor.quality().scale), render_s = 0.04 * scale * scale;
        governor.measured(governor.quality(), {.render_s = render_s, .frame_s = render_s + 0.02});
    }
    EXPECT_NEAR(governor.quality().scale, std::sqrt((0.99 / 30.0 - 0.02) / 0.04), 0.01);
}

TEST(Governor, counts_only_frames_of_the_quality_that_it_asks_for) {
    Governor governor = Governor::create(at_30).value();
    for (int i = 0; i < 100; ++i) governor.measured({0.5f, 3}, {.render_s = 9.0, .frame_s = 9.0});
    EXPECT_EQ(governor.quality(), (FrameQuality{1.0f, 3}));
}

TEST(Governor, takes_another_depth_when_told_to) {
    Loop loop(at_30, {.load = constant(0.1)});
    loop.frames(100);
    const float scale = loop.governor.quality().scale;
    loop.governor.set_greatest_depth(7);
    EXPECT_EQ(loop.governor.quality(), (FrameQuality{scale, 7}));
    loop.governor.set_greatest_depth(1);
    EXPECT_EQ(loop.governor.quality(), (FrameQuality{scale, 1}));
}

TEST(Governor, stays_within_its_bounds_whatever_it_is_told) {
    const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    const double odd[] = {0.0, -1.0, 1e-300, 1e-9, 1e-3, 0.033, 0.1, 1.0, 1e5, 1e300, infinite, -infinite, nan};
    Random random(3);
    for (const double fps : {1e-6, 0.5, 30.0, 1000.0}) {
        Governor governor =
            Governor::create({.target_fps = fps, .least_scale = 0.3f, .least_depth = 1, .greatest_depth = 4}).value();
        uint32_t greatest = 4;
        for (int i = 0; i < 20000; ++i) {
            const auto time = [&] {
                return random.below(4) == 0 ? odd[random.below(std::size(odd))] : double(random.uniform(0.0f, 0.2f));
            };
            const FrameTimes times{time(), time(), time(), random.below(2) == 0 ? 0.0 : time()};
            governor.measured(random.below(8) == 0 ? FrameQuality{random.uniform(0, 1), 2} : governor.quality(), times);
            if (random.below(1000) == 0) {
                greatest = std::max(1u, random.below(6));
                governor.set_greatest_depth(greatest);
            }
            const FrameQuality quality = governor.quality();
            ASSERT_TRUE(quality.scale >= 0.3f && quality.scale <= 1.0f) << quality.scale;
            ASSERT_TRUE(quality.depth >= 1 && quality.depth <= greatest) << quality.depth;
        }
    }
}

} // namespace
} // namespace glint::test
