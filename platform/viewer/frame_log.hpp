// What the frames took: for the display while the viewer runs, and for a report when it ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glint::viewer {

/// A frame that was shown. Times in seconds.
struct ShownFrame {
    double shown_s = 0.0;    ///< since the viewer began
    double interval_s = 0.0; ///< since the frame before; 0 where it did not follow at once
    double render_s = 0.0;
    double upload_s = 0.0;
    double gl_s = 0.0;       ///< drawing and swapping
    double wait_s = 0.0;     ///< of the interval, waited on purpose
    double latency_s = -1.0; ///< from an event to the picture that shows it; below 0 where no event was waited for
    double stop_s = -1.0;    ///< a refinement's, told to stop by this frame; below 0 where there was none
    uint64_t rays = 0;
    uint32_t width_px = 0, height_px = 0, depth = 0, samples = 1;
    float scale = 1.0f;
    bool refines = false; ///< a pass of a picture at rest
};

struct Quantiles {
    double median = 0.0, p95 = 0.0, max = 0.0;
    uint64_t count = 0;
};
/// Of values in any order.
[[nodiscard]] Quantiles quantiles_of(std::vector<double> values);

/// Keeps every frame while there is room, then the newest: a viewer may run for days. All the room is taken at once, 7
/// MB: a viewer that runs for days does not grow.
class FrameLog {
public:
    static constexpr size_t most_frames = size_t{1} << 16;

    FrameLog();
    void add(const ShownFrame &frame);
    /// In the order in which they were shown.
    [[nodiscard]] const std::vector<ShownFrame> &frames() const { return frames_; }
    [[nodiscard]] uint64_t count() const { return count_; } ///< of all, also of those forgotten

    /// Intervals between frames that followed each other.
    [[nodiscard]] std::vector<double> intervals_s() const;
    [[nodiscard]] std::vector<double> latencies_s() const;
    /// From events to pictures: frames shown after the event, that which shows it included.
    [[nodiscard]] std::vector<double> latencies_in_frames() const;
    [[nodiscard]] std::vector<double> stops_s() const;
    /// Frames a second where they followed each other; 0 where none did.
    [[nodiscard]] double fps() const;
    /// Changes of scale a second where frames followed each other.
    [[nodiscard]] double scale_changes_per_s() const;

private:
    std::vector<ShownFrame> frames_;
    uint64_t count_ = 0;
};

} // namespace glint::viewer
