// Holds a frame rate: the picture gets coarser, then shallower, before frames come late.
#pragma once

#include <cstdint>

#include <glint/export.hpp>
#include <glint/result.hpp>

namespace glint {

/// What to hold, and how far quality may go down for it.
struct GovernorOptions {
    double target_fps = 60.0;  ///< frames a second, above 0 and at most 1000
    float least_scale = 0.25f; ///< of the window's width and height, in (0, 1]; the greatest is 1
    uint32_t least_depth = 0;  ///< recursive rays in a row
    uint32_t greatest_depth = 1;
};

/// How the next frame is to be rendered.
struct FrameQuality {
    float scale = 1.0f; ///< of the picture's width and height to the window's; see scaled_size()
    uint32_t depth = 0; ///< RenderOptions::max_depth
    friend bool operator==(const FrameQuality &, const FrameQuality &) = default;
};

/// What one frame took, by the clock on the wall, in seconds.
struct FrameTimes {
    double render_s = 0.0; ///< of Renderer::render(): what shrinks with the scale
    /// Of presenting that runs beside the next frame's tracing: upload, drawing, swap. 0 in a loop that traces and
    /// presents by turns: there it is a part of frame_s.
    double present_s = 0.0;
    double frame_s = 0.0; ///< from the end of the frame before to the end of this one
    /// What of frame_s nobody worked in because the loop waited on purpose: for its next turn, for the display. Without
    /// it a loop that waits would look as if it had no time left.
    double wait_s = 0.0;
};

/// Chooses a resolution scale and, once that is at its least, a depth, so that frames take 1 / target_fps.
///
/// What it governs is the time between frames less the time waited, frame_s - wait_s. Of that render_s is taken to grow
/// with the square of the scale. What neither render_s nor present_s explains stays as it is: presenting that runs
/// beside tracing costs nothing while it is the shorter of the two, and no scale helps while it alone is too long.
///
/// A change of load by more than a quarter is answered within three frames, by one step; a single slow frame never.
/// Slow changes are answered when an average over the last fifth of a second leaves a band around the target, of a few
/// percent and what the noise seen in the times makes uncertain. At the least scale the depth goes down step by step.
/// It comes back first: as soon as a deeper frame is expected to fit at the least scale with room to spare, from what
/// depth cost when it was given up.
///
/// Knows no clock and no threads; one thread at a time calls it.
class GLINT_API Governor {
public:
    /// Fails with bad_input when an option is not a number or out of range. Begins with scale 1 and greatest_depth.
    [[nodiscard]] static Result<Governor> create(const GovernorOptions &options);

    /// Of the next frame.
    [[nodiscard]] FrameQuality quality() const { return quality_; }

    /// Tells what a frame took that was rendered with the given quality(). Frames in flight while the quality changed
    /// are told with theirs and do not count. Times that are negative or no numbers are ignored.
    void measured(const FrameQuality &quality, const FrameTimes &times);

    /// Another greatest depth, and the depth from now on, as when a person chooses one; not below least_depth. The
    /// scale stays.
    void set_greatest_depth(uint32_t depth);

    [[nodiscard]] const GovernorOptions &options() const { return options_; }

private:
    explicit Governor(const GovernorOptions &options);

    /// A time of the frames since the quality changed. One frame alone never counts: the mean is one of medians.
    struct Average {
        double last[3] = {};
        double mean = 0.0; ///< from the third frame on
        void add(double value, uint32_t count, uint32_t window);
        [[nodiscard]] double median() const;
    };

    void watch_noise(double lately_s);
    [[nodiscard]] double render_allowed_s(double rest_s) const;
    [[nodiscard]] bool go_deeper();
    void re_aim(double render_s, double rest_s);
    void change_to(const FrameQuality &quality);

    GovernorOptions options_;
    FrameQuality quality_;
    uint32_t window_;     ///< frames that a mean is over
    uint32_t frames_ = 0; ///< of this quality
    Average render_, rest_;
    double noise_ = 0.05;            ///< standard deviation of a frame's time, as a share of it
    double deeper_costs_;            ///< tracing one ray deeper over tracing as it is now
    double given_up_render_s_ = 0.0; ///< what it took before the depth went down, until deeper_costs_ is known
};

/// Of a picture in pixels.
struct PictureSize {
    uint32_t width_px = 1, height_px = 1;
    friend bool operator==(const PictureSize &, const PictureSize &) = default;
};

/// The size of a picture of that scale in (0, 1] for a window of that size, each at least 1: the window's own at scale
/// 1, else of the same shape and of a width that is a multiple of a few pixels, by about a two-hundredth of the
/// window's, so that scales that hardly differ give equal sizes.
[[nodiscard]] GLINT_API PictureSize scaled_size(uint32_t width_px, uint32_t height_px, float scale);

} // namespace glint
