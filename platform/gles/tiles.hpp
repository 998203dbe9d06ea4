// Cutting a picture into parts that textures are large enough for.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace glint::gles {

/// A part of a picture. Parts touch; their textures overlap, so that a filter finds the same neighbours as in one large
/// texture. All in pixels of the picture, from its top left corner.
struct Tile {
    uint32_t x, y, width_px, height_px;                                 ///< what it shows
    uint32_t texture_x, texture_y, texture_width_px, texture_height_px; ///< what its texture holds

    bool operator==(const Tile &) const = default;
};

/// How many texels on each side of a place the widest filter asks for.
inline constexpr uint32_t filter_reach_px = 2;

/// Rows of tiles that cover the picture, none with a texture larger than `largest_px` a side: one where that suffices.
/// Empty where `largest_px` leaves nothing between two borders.
[[nodiscard]] std::vector<Tile> cut_into_tiles(uint32_t width_px, uint32_t height_px, uint32_t largest_px);

/// Two triangles that show the tile in a viewport which shows the whole picture: six times x y (on the screen), s t (in
/// the tile's texture). Tiles that touch have the same numbers at their common edge, so no pixel is left out or drawn
/// twice.
using TileVertices = std::array<float, 24>;
[[nodiscard]] TileVertices tile_vertices(const Tile &tile, uint32_t width_px, uint32_t height_px);

} // namespace glint::gles
