// A whole tile: camera rays, levels of recursion, bytes.
#pragma once

#include "kernel/packet/lighting.hpp"

namespace glint::HWY_NAMESPACE {

/// Where a ray's pixel stands in a tile of 16 x 16: blocks of 4 x 4, in rows.
struct PixelPlace {
    uint32_t x, y;
};
HWY_INLINE PixelPlace place_of(uint32_t ray) {
    const uint32_t block = ray / block_size, within = ray % block_size;
    return {block % 4 * 4 + within % 4, block / 4 * 4 + within / 4};
}

/// Where the lanes of a vector stand in its block.
alignas(64) inline constexpr float lane_x[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) inline constexpr float lane_y[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// Calls visit(ray, place, inside) for every vector of a tile's rays of which any is inside the picture; `inside` says
/// which.
template <typename Visit> HWY_INLINE void for_each_place(const Tile &tile, Visit &&visit) {
    const uint32_t width = tile.x1 - tile.x0, height = tile.y1 - tile.y0;
    const bool is_full = width == 16 && height == 16;
    for (uint32_t ray = 0; ray < group_size; ray += lane_count) {
        const PixelPlace first = place_of(ray);
        uint32_t inside = all_lanes;
        if (!is_full) {
            for (uint32_t lane = 0; lane < lane_count; ++lane) {
                if (first.x + lane % 4 >= width || first.y + lane / 4 >= height) inside &= ~(1u << lane);
            }
            if (inside == 0) continue;
        }
        visit(ray, first, inside);
    }
}

/// The rays through the centres of a tile's pixels.
HWY_INLINE void make_primary_rays(const KernelFrame &frame, const Tile &tile, RayLevel &level) {
    const Camera &camera = frame.camera;
    const Floats inverse_width = splat(1.0f / static_cast<float>(frame.width_px));
    const Floats inverse_height = splat(1.0f / static_cast<float>(frame.height_px));
    const Points to_corner = {splat(camera.top_left.x - camera.eye.x), splat(camera.top_left.y - camera.eye.y),
                              splat(camera.top_left.z - camera.eye.z)};
    const Points right = points_of(camera.right), down = points_of(camera.down);
    // What depends on the column alone, and on the row.
    Points from_corner[4], from_edge[block_size / lane_count * 4];
    for (uint32_t column = 0; column < 4; ++column) {
        const Floats x = splat(static_cast<float>(tile.x0 + 4 * column)) + hn::Load(floats, lane_x);
        from_corner[column] = sum(to_corner, scaled(right, (x + splat(0.5f)) * inverse_width));
    }
    constexpr uint32_t rows_of_lanes = lane_count / 4;
    for (uint32_t row = 0; row < 16; row += rows_of_lanes) {
        const Floats y = splat(static_cast<float>(tile.y0 + row)) + hn::Load(floats, lane_y);
        from_edge[row / rows_of_lanes] = scaled(down, (y + splat(0.5f)) * inverse_height);
    }
    level.selection.clear();
    level.depth = 0;
    level.rays.shared_origin = {camera.eye.x, camera.eye.y, camera.eye.z};
    for_each_place(tile, [&](uint32_t ray, PixelPlace first, uint32_t inside) {
        level.rays.set_dir(ray, normalized(sum(from_corner[first.x / 4], from_edge[first.y / rows_of_lanes])));
        level.selection.add(ray, inside);
        hn::Store(splat(__FLT_MAX__), floats, level.rays.t + ray);
        hn::Store(hn::Set(uints, no_triangle), uints, level.rays.triangle_id + ray);
        hn::Store(hn::Set(uints, no_triangle), uints, level.rays.left + ray);
        hn::Store(splat(1.0f), floats, level.weight + ray);
    });
}

/// resolve_channel() of image/resolve.hpp for every lane, in the lowest eight bits of a number whose others are those
/// of 2^23.
HWY_INLINE Uints resolve_channels(Floats c) {
    const FloatMask positive = hn::Gt(c, hn::Zero(floats));
    const Floats clamped = hn::IfThenElseZero(positive, hn::Min(c, splat(1.0f)));
    const Floats scaled_up = splat(255.0f) * clamped;
    // The nearest number, the even one of two; then the upper one of two.
    const Floats shifted = scaled_up + splat(0x1p23f);
    const FloatMask was_half = hn::Eq(scaled_up - (shifted - splat(0x1p23f)), splat(0.5f));
    return hn::BitCast(uints, shifted + hn::IfThenElseZero(was_half, splat(1.0f)));
}

/// Writes the tile's pixels.
HWY_INLINE void resolve_tile(const KernelFrame &frame, const Tile &tile, const TileColors &colors) {
    const size_t first_pixel = size_t{tile.y0} * frame.width_px + tile.x0;
    const auto for_each_row = [&](PixelPlace first, uint32_t inside, auto &&copy) {
        size_t pixel = first_pixel + size_t{first.y} * frame.width_px + first.x;
        for (uint32_t row = 0; row < lane_count / 4; ++row, pixel += frame.width_px) {
            copy(row, pixel, static_cast<uint32_t>(__builtin_popcount(inside >> (4 * row) & 15)));
        }
    };
    for_each_place(tile, [&](uint32_t ray, PixelPlace first, uint32_t inside) {
        const Points color = colors.at(ray);
        // The shifts push the bits of 2^23 out.
        const Uints rgba = hn::Xor(hn::Xor(resolve_channels(color.x), hn::ShiftLeft<8>(resolve_channels(color.y))),
                                   hn::Xor(hn::ShiftLeft<16>(resolve_channels(color.z)), hn::Set(uints, 0xb4000000u)));
        alignas(64) uint32_t bytes[lane_count];
        hn::Store(rgba, uints, bytes);
        if (inside == all_lanes) {
            for_each_row(first, inside, [&](uint32_t row, size_t pixel, uint32_t) {
                __builtin_memcpy(frame.rgba8 + pixel * 4, bytes + row * 4, 16);
            });
        } else {
            for_each_row(first, inside, [&](uint32_t row, size_t pixel, uint32_t columns) {
                if (columns != 0) __builtin_memcpy(frame.rgba8 + pixel * 4, bytes + row * 4, 4 * columns);
            });
        }
        if (frame.radiance) {
            alignas(64) float rgb[3 * lane_count];
            hn::StoreInterleaved3(color.x, color.y, color.z, floats, rgb);
            for_each_row(first, inside, [&](uint32_t row, size_t pixel, uint32_t columns) {
                if (columns != 0) __builtin_memcpy(frame.radiance + pixel * 3, rgb + row * 12, 12 * columns);
            });
        }
    });
}

/// A level waits while the rays that branched off beside it are followed: one a depth at most.
HWY_INLINE size_t scratch_bytes(const KernelScene &scene, const KernelFrame &frame) {
    const size_t waiting = scene.may_branch ? frame.max_depth : 0;
    return sizeof(TileWork) + (waiting + 1) * sizeof(RayLevel);
}

HWY_INLINE void render_tile(const KernelScene &scene, const KernelFrame &frame, Tile tile, KernelScratch &scratch) {
    TileWork &work = *reinterpret_cast<TileWork *>(scratch.memory);
    RayLevel *const waiting = reinterpret_cast<RayLevel *>(scratch.memory + sizeof(TileWork));
    uint32_t waiting_count = 0;
    work.beams = &scratch.beams;
    work.level = &work.levels[0];
    work.next = &work.levels[1];
    make_primary_rays(frame, tile, *work.level);
    scratch.rays.primary += work.level->selection.count();
    work.colors.clear();
    while (true) {
        trace_level(scene.geometry, *work.level, *work.beams);
        RayLevel &branch = waiting[waiting_count];
        scratch.rays.secondary += reach_surfaces(scene, frame.max_depth, work, branch);
        scratch.rays.shadow += add_local_colors(scene, work);
        if (!branch.selection.empty()) ++waiting_count;
        if (!work.next->selection.empty()) {
            RayLevel *const done = work.level;
            work.level = work.next;
            work.next = done;
        } else if (waiting_count > 0) {
            __builtin_memcpy(work.level, &waiting[--waiting_count], sizeof(RayLevel));
        } else {
            break;
        }
    }
    resolve_tile(frame, tile, work.colors);
}

} // namespace glint::HWY_NAMESPACE
