// What a log of frames says of them.
#include "viewer/frame_log.hpp"

#include <gtest/gtest.h>

namespace glint::viewer {
namespace {

ShownFrame frame(double interval_s, float scale = 1.0f, double latency_s = -1.0) {
    ShownFrame shown;
    shown.interval_s = interval_s;
    shown.scale = scale;
    shown.latency_s = latency_s;
    return shown;
}

TEST(FrameLog, counts_only_frames_that_followed_each_other) {
    FrameLog log;
    EXPECT_EQ(log.fps(), 0.0);
    for (const double interval : {0.0, 0.01, 0.03, 0.0, 0.02}) log.add(frame(interval));
    EXPECT_EQ(log.count(), 5u);
    EXPECT_DOUBLE_EQ(log.fps(), 50.0);
    const Quantiles of = quantiles_of(log.intervals_s());
    EXPECT_EQ(of.count, 3u);
    EXPECT_EQ(of.median, 0.02);
    EXPECT_EQ(of.max, 0.03);
}

TEST(FrameLog, tells_latencies_in_seconds_and_in_frames_shown_since) {
    FrameLog log;
    const auto show = [&](double shown_s, double latency_s) {
        ShownFrame shown = frame(0.01, 1.0f, latency_s);
        shown.shown_s = shown_s;
        log.add(shown);
    };
    show(1.00, 0.50);  // the first frame there is
    show(1.01, -1.0);  // shows no event
    show(1.02, 0.015); // that of 1.005: the frame before was shown after it, too
    show(1.03, 0.005);
    show(1.09, 0.065);  // late, but the next one: that of 1.025 came while the frame before was on its way
    show(1.091, 0.066); // so was this, two frames before
    EXPECT_EQ(log.latencies_s(), (std::vector<double>{0.5, 0.015, 0.005, 0.065, 0.066}));
    EXPECT_EQ(log.latencies_in_frames(), (std::vector<double>{1, 2, 1, 2, 3}));
}

TEST(FrameLog, counts_changes_of_scale_by_time) {
    FrameLog log;
    log.add(frame(0.0, 1.0f));
    for (int i = 0; i < 10; ++i) log.add(frame(0.1, i < 4 ? 1.0f : 0.5f));
    EXPECT_DOUBLE_EQ(log.scale_changes_per_s(), 1.0);
}

TEST(FrameLog, forgets_the_oldest) {
    FrameLog log;
    for (size_t i = 0; i < FrameLog::most_frames + 10; ++i) log.add(frame(static_cast<double>(i)));
    EXPECT_EQ(log.count(), FrameLog::most_frames + 10);
    EXPECT_LE(log.frames().size(), FrameLog::most_frames);
    EXPECT_EQ(log.frames().back().interval_s, static_cast<double>(FrameLog::most_frames + 9));
}

TEST(FrameLog, of_no_frames_has_no_quantiles) {
    EXPECT_EQ(quantiles_of({}).count, 0u);
    EXPECT_EQ(FrameLog().scale_changes_per_s(), 0.0);
}

} // namespace
} // namespace glint::viewer
