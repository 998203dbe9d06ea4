// Pixels to draw on: rectangles, clipped at the edges.
#include "viewer/hud/canvas.hpp"

#include <algorithm>
#include <cstring>

namespace glint::viewer {

namespace {

constexpr int bytes_a_pixel = 4;

/// The colour over what is there, both with straight alpha (Porter & Duff 1984, "Compositing digital images").
Rgba over(Rgba top, Rgba below) {
    if (top.a == 255 || below.a == 0) return top;
    // In 255ths of 255ths: what of the sum is the upper colour's, what the lower one's.
    const int of_top = top.a * 255, of_below = below.a * (255 - top.a), sum = of_top + of_below;
    if (sum == 0) return {0, 0, 0, 0};
    const auto mix = [&](uint8_t a, uint8_t b) {
        return static_cast<uint8_t>((a * of_top + b * of_below + sum / 2) / sum);
    };
    return {mix(top.r, below.r), mix(top.g, below.g), mix(top.b, below.b), static_cast<uint8_t>((sum + 127) / 255)};
}

} // namespace

Rectangle Rectangle::within(const Rectangle &other) const {
    return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1), std::min(y1, other.y1)};
}

Rectangle Rectangle::with(const Rectangle &other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1), std::max(y1, other.y1)};
}

Canvas::Canvas(uint8_t *rgba8, uint32_t width_px, uint32_t height_px, size_t stride_bytes)
    : rgba8_(rgba8),
      width_px_(static_cast<int>(width_px)),
      height_px_(static_cast<int>(height_px)),
      stride_bytes_(stride_bytes) {}

Rgba Canvas::at(int x, int y) const {
    const uint8_t *const p = row(y) + ptrdiff_t{x} * bytes_a_pixel;
    return {p[0], p[1], p[2], p[3]};
}

void Canvas::clear() const {
    for (int y = 0; y < height_px_; ++y) std::memset(row(y), 0, static_cast<size_t>(width_px_) * bytes_a_pixel);
}

void Canvas::fill(const Rectangle &area, Rgba color) const {
    const Rectangle drawn = area.within(bounds());
    for (int y = drawn.y0; y < drawn.y1; ++y) {
        for (int x = drawn.x0; x < drawn.x1; ++x) {
            const Rgba mixed = over(color, at(x, y));
            uint8_t *const p = row(y) + ptrdiff_t{x} * bytes_a_pixel;
            p[0] = mixed.r;
            p[1] = mixed.g;
            p[2] = mixed.b;
            p[3] = mixed.a;
        }
    }
}

uint8_t *Canvas::row(int y) const {
    return rgba8_ + static_cast<size_t>(y) * stride_bytes_;
}

} // namespace glint::viewer
