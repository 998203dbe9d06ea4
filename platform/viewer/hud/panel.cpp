// A dark, translucent plate with rows of text.
#include "viewer/hud/panel.hpp"

#include <algorithm>

#include "viewer/hud/text.hpp"

namespace glint::viewer {

Rectangle Panel::size(int columns, int rows, int extra_px, int scale) {
    // The last letter and the last row need no distance to another one.
    const int width = columns * Glyph::advance_px - (Glyph::advance_px - Glyph::width_px);
    const int height = rows * row_px + (extra_px > 0 ? extra_px : Glyph::height_px - row_px);
    return {0, 0, (width + 2 * margin_px) * scale, (height + 2 * margin_px) * scale};
}

Panel::Panel(const Canvas &canvas, const Rectangle &area, int scale)
    : canvas_(canvas), area_(area.within(canvas.bounds())), inside_(area_.inset(margin_px * scale)), scale_(scale) {
    canvas_.fill(area_, ink::plate);
}

int Panel::columns() const {
    const int gap = (Glyph::advance_px - Glyph::width_px) * scale_;
    return std::max(0, (inside_.width() + gap) / (Glyph::advance_px * scale_));
}

int Panel::rows() const {
    const int gap = (row_px - Glyph::height_px) * scale_;
    return std::max(0, (inside_.height() + gap) / (row_px * scale_));
}

void Panel::text(int row, std::string_view text, Rgba color, int column) const {
    if (row >= rows()) return;
    draw_text(canvas_, x_of(column), y_of(row), cut_to(text, columns() - column), color, scale_);
}

void Panel::ends(int row, std::string_view left, Rgba left_color, std::string_view right, Rgba right_color) const {
    text(row, left, left_color);
    const int column = columns() - columns_of(right);
    if (column > columns_of(left)) text(row, right, right_color, column);
}

void Panel::swatch(int row, int column, int columns, Rgba color) const {
    if (row >= rows() || column + columns > this->columns()) return;
    const int x = x_of(column), y = y_of(row);
    constexpr int letter_px = 7;
    canvas_.fill({x, y, x + (columns * Glyph::advance_px - 1) * scale_, y + letter_px * scale_}, color);
}

Rectangle Panel::below(int rows) const {
    return {inside_.x0, y_of(rows), inside_.x1, inside_.y1};
}

int Panel::x_of(int column) const {
    return inside_.x0 + column * Glyph::advance_px * scale_;
}

int Panel::y_of(int row) const {
    return inside_.y0 + row * row_px * scale_;
}

} // namespace glint::viewer
