// The heads-up display: figures, frame times, help and a pixel's rays, drawn over the picture by the CPU.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "viewer/hud/canvas.hpp"

namespace glint {
struct RayTree;
}

namespace glint::viewer {

/// What the loop measured and what it chose. Times are milliseconds a frame, smoothed by whoever measures.
struct HudFigures {
    double render_ms = 0.0; ///< tracing
    double upload_ms = 0.0; ///< into the texture
    double gl_ms = 0.0;     ///< drawing and swapping
    double fps = 0.0;
    double mrays_per_s = 0.0; ///< millions of rays a second of tracing
    uint32_t depth = 0;       ///< most recursive rays in a row
    float scale = 1.0f;       ///< of the resolution; 1 = the window's own
    unsigned threads = 1;
    std::string isa;
    uint32_t samples = 1;                 ///< a pixel, so far
    uint32_t width_px = 0, height_px = 0; ///< of the traced picture
    bool is_paused = false;
};

/// A row of the help page.
struct HudKey {
    std::string_view keys;    ///< "left drag"
    std::string_view meaning; ///< "orbit"
};

/// What to show. Everything that is pointed to must live until draw_hud() returns.
struct HudContent {
    HudFigures figures;
    bool shows_figures = true;

    /// Graph of the frame times below the figures: the last most_frame_times of these, the oldest first; empty = none.
    static constexpr uint32_t most_frame_times = 120;
    std::span<const float> frame_times_ms;
    float target_ms = 0.0f; ///< a line across the graph; 0 = none

    /// The help page, in the middle; empty = none.
    std::span<const HudKey> help;

    /// A pixel's rays, along the right or, in a narrow window, the lower edge; nullptr = none.
    const RayTree *ray_tree = nullptr;
    uint32_t first_ray = 0; ///< rows of the list that were scrolled away

    /// A line at the lower edge ("saved shot.png"); empty = none.
    std::string message;
};

/// Draws the display: the whole canvas is written, with transparent black where there is nothing to show. Colours are
/// as displays take them, with straight alpha, to be blended over the picture. Letters are 6 x 10 pixels, times `scale`
/// (from 1; 2 for displays of twice the usual density). Returns the part of the canvas outside of which nothing was
/// drawn, so that no more need be uploaded; it may be empty.
Rectangle draw_hud(const Canvas &canvas, const HudContent &content, uint32_t scale = 1);

} // namespace glint::viewer
