// The times of the last frames as bars.
#pragma once

#include <span>

#include "viewer/hud/canvas.hpp"

namespace glint::viewer {

/// What time the graph's upper edge stands for: twice the target (33 1/3 ms without one), doubled until not more than
/// one frame in sixteen is above it. So a single slow frame does not flatten all others.
[[nodiscard]] float graph_top_ms(std::span<const float> frame_times_ms, float target_ms);

/// Rows that a bar fills of a graph so high: at least one where it took any time, at most all.
[[nodiscard]] int bar_height(float frame_ms, float top_ms, int height_px);

/// Bars `scale` pixels wide, the newest at the right edge, as many as there is room for; a line at the target, if > 0.
void draw_frame_graph(const Canvas &canvas, const Rectangle &area, std::span<const float> frame_times_ms,
                      float target_ms, int scale);

} // namespace glint::viewer
