// The heads-up display as it stands: drawn anew only when there is something new to read.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include <glint/gles/pixel_view.hpp>

#include "viewer/frame_log.hpp"
#include "viewer/frame_pipeline.hpp"
#include "viewer/hud/hud.hpp"

namespace glint::viewer {

class Overlay {
public:
    /// What of the window is covered, and where, from its top left corner. Without pixels where nothing is.
    struct Pixels {
        gles::PixelView pixels;
        int x = 0, y = 0;
        uint64_t version = 0; ///< the same number: the same pixels
    };

    /// A frame was shown: its times count in the figures and the graph.
    void add(const ShownFrame &frame);
    /// A line that is shown for some seconds.
    void say(std::string message);
    /// What is shown has changed: the next draw() draws.
    void invalidate() { is_stale_ = true; }
    /// Whether a message has been shown long enough and is to go.
    [[nodiscard]] bool has_old_message(Clock::time_point now) const;

    /// The display with this content, whose figures, frame times and message are filled in, as far as they come from
    /// frames. It is a tenth of a second old at most, and valid until the next call.
    [[nodiscard]] Pixels draw(HudContent content, uint32_t width_px, uint32_t height_px, uint32_t scale,
                              Clock::time_point now);

private:
    std::deque<ShownFrame> frames_; // the newest, as many as the graph shows
    std::string message_;
    Clock::time_point said_, drawn_;
    bool is_stale_ = true, is_new_message_ = false, has_new_frames_ = false;
    std::vector<uint8_t> canvas_;
    std::vector<float> times_ms_;
    uint32_t width_px_ = 0, height_px_ = 0;
    Pixels pixels_;
};

} // namespace glint::viewer
