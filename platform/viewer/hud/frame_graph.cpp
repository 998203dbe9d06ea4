// The times of the last frames as bars.
#include "viewer/hud/frame_graph.hpp"

#include <algorithm>
#include <cmath>

#include "viewer/hud/panel.hpp"

namespace glint::viewer {

namespace {

constexpr float longest_ms = 1e6f; // no graph shows longer frames

/// A frame is slow when it misses its target by more than measurements vary.
Rgba color_of(float frame_ms, float top_ms, float target_ms) {
    if (frame_ms > top_ms) return ink::bad;
    return target_ms > 0.0f && frame_ms > 1.1f * target_ms ? ink::slow : ink::good;
}

} // namespace

float graph_top_ms(std::span<const float> frame_times_ms, float target_ms) {
    float top = target_ms > 0.0f && target_ms < longest_ms ? 2.0f * target_ms : 100.0f / 3.0f;
    const auto above = [&] {
        return std::count_if(frame_times_ms.begin(), frame_times_ms.end(), [&](float ms) { return ms > top; });
    };
    while (top<longest_ms &&static_cast<size_t>(above()) * 16> frame_times_ms.size()) top *= 2.0f;
    return top;
}

int bar_height(float frame_ms, float top_ms, int height_px) {
    if (!(frame_ms > 0.0f) || height_px <= 0) return 0;
    if (frame_ms >= top_ms) return height_px;
    return std::max(1, static_cast<int>(std::lround(frame_ms / top_ms * static_cast<float>(height_px))));
}

void draw_frame_graph(const Canvas &canvas, const Rectangle &area, std::span<const float> frame_times_ms,
                      float target_ms, int scale) {
    if (area.empty()) return;
    const size_t room = static_cast<size_t>(area.width() / scale);
    const std::span<const float> shown = frame_times_ms.last(std::min(room, frame_times_ms.size()));
    const float top_ms = graph_top_ms(shown, target_ms);
    int right = area.x1;
    for (auto ms = shown.rbegin(); ms != shown.rend(); ++ms, right -= scale) {
        const int top = area.y1 - bar_height(*ms, top_ms, area.height());
        canvas.fill({right - scale, top, right, area.y1}, color_of(*ms, top_ms, target_ms));
    }
    if (!(target_ms > 0.0f)) return;
    const int line = area.y1 - bar_height(target_ms, top_ms, area.height());
    canvas.fill({area.x0, line, area.x1, line + scale}, {255, 255, 255, 150});
}

} // namespace glint::viewer
