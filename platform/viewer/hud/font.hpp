// A small bitmap font of our own: printable ASCII, each letter 5 x 9 pixels in a cell of 6 x 10.
#pragma once

namespace glint::viewer {

struct Glyph {
    static constexpr int width_px = 5, height_px = 9;
    /// From one letter, and one line, to the next.
    static constexpr int advance_px = 6, line_px = 10;

    /// The letter for a byte; a hollow box for bytes that are not printable ASCII.
    explicit Glyph(char letter);

    /// Whether the letter has ink there, 0 <= x < width_px from its left and 0 <= y < height_px from its top. Capitals
    /// take the rows 0 to 6; the two below are for what hangs down.
    [[nodiscard]] bool has_ink(int x, int y) const;

private:
    bool is_known_;
    int strip_, column_;
};

} // namespace glint::viewer
