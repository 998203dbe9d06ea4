// Lines of text on a canvas.
#include "viewer/hud/text.hpp"

namespace glint::viewer {

namespace {

/// What is not ASCII shows as one box a character, not one a byte.
bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

void draw_glyph(const Canvas &canvas, int left, int top, const Glyph &glyph, Rgba color, int scale) {
    for (int y = 0; y < Glyph::height_px; ++y) {
        for (int x = 0; x < Glyph::width_px; ++x) {
            if (!glyph.has_ink(x, y)) continue;
            const int x0 = left + x * scale, y0 = top + y * scale;
            canvas.fill({x0, y0, x0 + scale, y0 + scale}, color);
        }
    }
}

} // namespace

int columns_of(std::string_view text) {
    int columns = 0;
    for (const char byte : text) columns += continues(byte) ? 0 : 1;
    return columns;
}

std::string cut_to(std::string_view text, int columns) {
    if (columns_of(text) <= columns) return std::string(text);
    constexpr std::string_view dots = "..";
    std::string cut;
    int left = columns - static_cast<int>(dots.size());
    for (const char byte : text) {
        if (!continues(byte) && left-- <= 0) break;
        cut += byte;
    }
    return cut + std::string(dots.substr(0, static_cast<size_t>(columns > 0 ? columns : 0)));
}

void draw_text(const Canvas &canvas, int x, int y, std::string_view text, Rgba color, int scale) {
    const Rectangle bounds = canvas.bounds();
    for (const char byte : text) {
        if (x >= bounds.x1) return;
        if (continues(byte)) continue;
        draw_glyph(canvas, x, y, Glyph(byte), color, scale);
        x += Glyph::advance_px * scale;
    }
}

} // namespace glint::viewer
