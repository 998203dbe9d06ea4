// A dark, translucent plate with rows of text.
#pragma once

#include <string_view>

#include "viewer/hud/canvas.hpp"

namespace glint::viewer {

namespace ink {
inline constexpr Rgba plate{10, 12, 16, 208};
inline constexpr Rgba bright{240, 242, 245, 255};
inline constexpr Rgba dim{158, 168, 182, 255};
inline constexpr Rgba good{96, 200, 120, 255};
inline constexpr Rgba slow{236, 184, 72, 255};
inline constexpr Rgba bad{236, 92, 80, 255};
} // namespace ink

/// Distances between plates and around their text, in the font's pixels.
inline constexpr int margin_px = 6;
inline constexpr int row_px = 11;

/// Draws its plate when it is made, and on it what it is told.
class Panel {
public:
    /// How large a plate for so many columns and rows of text is, and so many of the font's pixels below them.
    [[nodiscard]] static Rectangle size(int columns, int rows, int extra_px, int scale);

    Panel(const Canvas &canvas, const Rectangle &area, int scale);

    [[nodiscard]] const Rectangle &area() const { return area_; }
    [[nodiscard]] int columns() const;
    [[nodiscard]] int rows() const;
    /// Text from a column of a row on; what is too long for it is cut.
    void text(int row, std::string_view text, Rgba color, int column = 0) const;
    /// Text at both ends of a row or, where they would meet, the left one alone.
    void ends(int row, std::string_view left, Rgba left_color, std::string_view right, Rgba right_color) const;
    /// Fills so many columns of a row with a colour.
    void swatch(int row, int column, int columns, Rgba color) const;
    /// Below that many rows, down to the lower edge's margin.
    [[nodiscard]] Rectangle below(int rows) const;

private:
    [[nodiscard]] int x_of(int column) const;
    [[nodiscard]] int y_of(int row) const;

    const Canvas &canvas_;
    Rectangle area_, inside_;
    int scale_;
};

} // namespace glint::viewer
