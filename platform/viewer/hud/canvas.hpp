// Pixels to draw on: rectangles, clipped at the edges.
#pragma once

#include <cstddef>
#include <cstdint>

namespace glint::viewer {

/// Pixels with x0 <= x < x1 and y0 <= y < y1; row 0 is the top row.
struct Rectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] int height() const { return y1 - y0; }
    [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
    /// What both have.
    [[nodiscard]] Rectangle within(const Rectangle &other) const;
    /// The least one that has both in it.
    [[nodiscard]] Rectangle with(const Rectangle &other) const;
    /// The same without an edge of so many pixels.
    [[nodiscard]] Rectangle inset(int by) const { return {x0 + by, y0 + by, x1 - by, y1 - by}; }
    friend bool operator==(const Rectangle &, const Rectangle &) = default;
};

/// Straight alpha: the colour does not depend on how much of it there is.
struct Rgba {
    uint8_t r = 0, g = 0, b = 0, a = 255;
    friend bool operator==(const Rgba &, const Rgba &) = default;
};

/// Somebody's pixels, R, G, B, A bytes with straight alpha. Whatever lies outside is not drawn.
class Canvas {
public:
    /// Rows of `stride_bytes` from the top. Sides of less than 2^30 pixels; the pixels outlive the canvas.
    Canvas(uint8_t *rgba8, uint32_t width_px, uint32_t height_px, size_t stride_bytes);

    [[nodiscard]] Rectangle bounds() const { return {0, 0, width_px_, height_px_}; }
    /// The pixel at x, y, which lies inside.
    [[nodiscard]] Rgba at(int x, int y) const;

    /// Makes every pixel transparent black.
    void clear() const;
    /// Blends the colour over what is there.
    void fill(const Rectangle &area, Rgba color) const;

private:
    [[nodiscard]] uint8_t *row(int y) const;

    uint8_t *rgba8_;
    int width_px_, height_px_;
    size_t stride_bytes_;
};

} // namespace glint::viewer
