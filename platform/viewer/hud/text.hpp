// Lines of text on a canvas.
#pragma once

#include <string>
#include <string_view>

#include "viewer/hud/canvas.hpp"
#include "viewer/hud/font.hpp"

namespace glint::viewer {

/// Columns that a text takes: its bytes, without the continuation bytes of UTF-8.
[[nodiscard]] int columns_of(std::string_view text);

/// The text or, where it has more columns, its beginning and "..".
[[nodiscard]] std::string cut_to(std::string_view text, int columns);

/// Draws a line of text with its top left corner at x, y, each of the font's pixels scale x scale large.
void draw_text(const Canvas &canvas, int x, int y, std::string_view text, Rgba color, int scale);

} // namespace glint::viewer
