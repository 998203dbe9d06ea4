// Cutting a picture into parts that textures are large enough for.
#include "gles/tiles.hpp"

#include <algorithm>

namespace glint::gles {

namespace {

/// A tile along one axis.
struct Span {
    uint32_t begin, size, texture_begin, texture_size;
};

std::vector<Span> cut(uint32_t size, uint32_t largest) {
    if (size <= largest) return {{0, size, 0, size}};
    if (largest <= 2 * filter_reach_px) return {};
    const uint32_t step = largest - 2 * filter_reach_px;
    std::vector<Span> spans;
    for (uint32_t begin = 0; begin < size; begin += step) {
        const uint32_t end = std::min(size - begin, step) + begin;
        const uint32_t texture_begin = begin - std::min(begin, filter_reach_px);
        const uint32_t texture_end = end + std::min(size - end, filter_reach_px);
        spans.push_back({begin, end - begin, texture_begin, texture_end - texture_begin});
        if (end == size) break; // before `begin` could overflow
    }
    return spans;
}

/// Where a pixel's edge lies in a viewport of that many pixels, from -1 to 1.
float on_screen(uint32_t edge, uint32_t size) {
    return static_cast<float>(2.0 * edge / size - 1.0);
}

float in_texture(uint32_t edge, uint32_t texture_begin, uint32_t texture_size) {
    return static_cast<float>(static_cast<double>(edge - texture_begin) / texture_size);
}

} // namespace

std::vector<Tile> cut_into_tiles(uint32_t width_px, uint32_t height_px, uint32_t largest_px) {
    std::vector<Tile> tiles;
    const std::vector<Span> columns = cut(width_px, largest_px);
    for (const Span &row : cut(height_px, largest_px)) {
        for (const Span &column : columns) {
            tiles.push_back({column.begin, row.begin, column.size, row.size, column.texture_begin, row.texture_begin,
                             column.texture_size, row.texture_size});
        }
    }
    return tiles;
}

TileVertices tile_vertices(const Tile &tile, uint32_t width_px, uint32_t height_px) {
    const uint32_t right_edge = tile.x + tile.width_px;
    const uint32_t bottom_edge = tile.y + tile.height_px;
    const float left = on_screen(tile.x, width_px);
    const float right = on_screen(right_edge, width_px);
    // The picture's first row is at t = 0 and belongs at the top, y = 1.
    const float top = -on_screen(tile.y, height_px);
    const float bottom = -on_screen(bottom_edge, height_px);
    const float s0 = in_texture(tile.x, tile.texture_x, tile.texture_width_px);
    const float s1 = in_texture(right_edge, tile.texture_x, tile.texture_width_px);
    const float t0 = in_texture(tile.y, tile.texture_y, tile.texture_height_px);
    const float t1 = in_texture(bottom_edge, tile.texture_y, tile.texture_height_px);
    // Six vertices rather than a strip of four: Mesa's llvmpipe recognises a rectangle in the former only.
    return {
        left, bottom, s0, t1, /**/ right, bottom, s1, t1, /**/ right, top, s1, t0, //
        left, bottom, s0, t1, /**/ right, top,    s1, t0, /**/ left,  top, s0, t0,
    };
}

} // namespace glint::gles
