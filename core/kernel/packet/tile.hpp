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

/// Directions from the eye to places in the pixels.
class PrimaryDirections {
public:
    HWY_INLINE explicit PrimaryDirections(const KernelFrame &frame)
        : inverse_width_(splat(1.0f / static_cast<float>(frame.width_px))),
          inverse_height_(splat(1.0f / static_cast<float>(frame.height_px))),
          to_corner_{splat(frame.camera.top_left.x - frame.camera.eye.x),
                     splat(frame.camera.top_left.y - frame.camera.eye.y),
                     splat(frame.camera.top_left.z - frame.camera.eye.z)},
          right_(points_of(frame.camera.right)),
          down_(points_of(frame.camera.down)) {}

    /// What depends on the column alone, and on the row; their sum is the direction.
    [[nodiscard]] HWY_INLINE Points column(Floats x) const {
        return sum(to_corner_, scaled(right_, x * inverse_width_));
    }
    [[nodiscard]] HWY_INLINE Points row(Floats y) const { return scaled(down_, y * inverse_height_); }

private:
    Floats inverse_width_, inverse_height_;
    Points to_corner_, right_, down_;
};

HWY_INLINE void start_ray(uint32_t ray, uint32_t inside, const Points &direction, RayLevel &level) {
    level.rays.set_dir(ray, normalized(direction));
    level.selection.add(ray, inside);
    hn::Store(splat(__FLT_MAX__), floats, level.rays.t + ray);
    hn::Store(hn::Set(uints, no_triangle), uints, level.rays.triangle_id + ray);
    hn::Store(hn::Set(uints, no_triangle), uints, level.rays.left + ray);
    hn::Store(splat(1.0f), floats, level.weight + ray);
}

/// The rays through one and the same place, told in pixels, of each of a tile's pixels.
HWY_INLINE void make_even_rays(const KernelFrame &frame, const Tile &tile, const float place[2], RayLevel &level) {
    const PrimaryDirections directions(frame);
    Points columns[4], rows[block_size / lane_count * 4];
    for (uint32_t column = 0; column < 4; ++column) {
        const Floats x = splat(static_cast<float>(tile.x0 + 4 * column)) + hn::Load(floats, lane_x);
        columns[column] = directions.column(x + splat(place[0]));
    }
    constexpr uint32_t rows_of_lanes = lane_count / 4;
    for (uint32_t row = 0; row < 16; row += rows_of_lanes) {
        const Floats y = splat(static_cast<float>(tile.y0 + row)) + hn::Load(floats, lane_y);
        rows[row / rows_of_lanes] = directions.row(y + splat(place[1]));
    }
    for_each_place(tile, [&](uint32_t ray, PixelPlace first, uint32_t inside) {
        start_ray(ray, inside, sum(columns[first.x / 4], rows[first.y / rows_of_lanes]), level);
    });
}

/// The rays through places at random in the pixels.
HWY_NOINLINE void make_scattered_rays(const KernelFrame &frame, const Tile &tile, uint32_t sample, RayLevel &level) {
    const PrimaryDirections directions(frame);
    for_each_place(tile, [&](uint32_t ray, PixelPlace first, uint32_t inside) {
        alignas(64) float x[lane_count], y[lane_count];
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            const uint32_t column = tile.x0 + first.x + lane % 4, row = tile.y0 + first.y + lane / 4;
            float place[2];
            one_lane::sample(frame.samples, column, row, sample, place);
            x[lane] = static_cast<float>(column) + place[0];
            y[lane] = static_cast<float>(row) + place[1];
        }
        const Points direction = sum(directions.column(hn::Load(floats, x)), directions.row(hn::Load(floats, y)));
        start_ray(ray, inside, direction, level);
    });
}

/// The rays through a sample of each of a tile's pixels.
HWY_INLINE void make_primary_rays(const KernelFrame &frame, const Tile &tile, uint32_t sample, RayLevel &level) {
    level.selection.clear();
    level.depth = 0;
    level.rays.shared_origin = {frame.camera.eye.x, frame.camera.eye.y, frame.camera.eye.z};
    level.is_even = frame.samples.pattern == SamplePattern::centre;
    if (level.is_even) {
        float place[2];
        one_lane::sample(frame.samples, 0, 0, sample, place);
        make_even_rays(frame, tile, place, level);
    } else {
        make_scattered_rays(frame, tile, sample, level);
    }
}

/// The eye's media, for all rays.
HWY_NOINLINE void set_eye_media(const KernelFrame &frame, RayLevel &level) {
    for (int i = 0; i < Media::most; ++i) {
        const Uints medium = hn::Set(uints, frame.eye_media.inside[i]);
        for (uint32_t ray = 0; ray < group_size; ray += lane_count) hn::Store(medium, uints, level.media[i] + ray);
    }
}

/// resolve_channel() of image/resolve.hpp for every lane, in the lowest eight bits of a number whose others are those
/// of 2^23.
HWY_INLINE Uints resolve_channels(Floats c) {
    const FloatMask positive = hn::Gt(c, hn::Zero(floats));
    const Floats clamped = hn::IfThenElseZero(positive, hn::Min(c, splat(1.0f)));
    // The float below a half is what may be added: a half itself would round the number just below it up (true of every
    // float from 0 to 255).
    const Floats rounded = hn::Floor(splat(255.0f) * clamped + splat(0x1.fffffep-2f));
    return hn::BitCast(uints, rounded + splat(0x1p23f));
}

/// displayed() of image/tone_curve.hpp for every lane.
HWY_INLINE Floats displayed(const KernelFrame &frame, Floats c) {
    const Floats zero = hn::Zero(floats), one = splat(1.0f);
    if (frame.tone_scale > 0.0f) {
        const Floats most = splat(1e30f);
        const Floats finite = hn::IfThenElse(hn::Lt(c, most), c, most);
        c = hn::IfThenElseZero(hn::Gt(c, zero), finite / (finite + splat(frame.tone_scale)));
    }
    if (frame.to_srgb) {
        const Floats clamped = hn::IfThenElseZero(hn::Gt(c, zero), hn::IfThenElse(hn::Lt(c, one), c, one));
        const Floats curved = splat(1.055f) * pow_unit(clamped, splat(1.0f / 2.4f)) - splat(0.055f);
        c = hn::IfThenElse(hn::Le(clamped, splat(0.0031308f)), splat(12.92f) * clamped, curved);
    }
    return c;
}

/// The mean of a tile's samples, in place.
HWY_NOINLINE void average(uint32_t sample_count, TileColors &colors) {
    const Floats share = splat(1.0f / static_cast<float>(sample_count));
    for (uint32_t ray = 0; ray < group_size; ray += lane_count) colors.set(ray, scaled(colors.at(ray), share));
}

/// What a display is to show of a tile's colours.
HWY_NOINLINE void make_displayed(const KernelFrame &frame, const TileColors &colors, TileColors &shown) {
    for (uint32_t ray = 0; ray < group_size; ray += lane_count) {
        const Points color = colors.at(ray);
        shown.set(ray, {displayed(frame, color.x), displayed(frame, color.y), displayed(frame, color.z)});
    }
}

/// Writes the tile's pixels: `colors` as radiance, `shown` as bytes.
HWY_INLINE void resolve_tile(const KernelFrame &frame, const Tile &tile, const TileColors &colors,
                             const TileColors &shown) {
    const size_t byte_stride = frame.rgba8_stride_bytes, light_stride = frame.radiance_stride_bytes / sizeof(float);
    uint8_t *const first_bytes = frame.rgba8 + tile.y0 * byte_stride + size_t{tile.x0} * 4;
    float *const first_light = frame.radiance ? frame.radiance + tile.y0 * light_stride + size_t{tile.x0} * 3 : nullptr;
    const auto columns_of = [](uint32_t row, uint32_t inside) {
        return static_cast<uint32_t>(__builtin_popcount(inside >> (4 * row) & 15));
    };
    for_each_place(tile, [&](uint32_t ray, PixelPlace first, uint32_t inside) {
        const Points color = shown.at(ray);
        // The shifts push the bits of 2^23 out.
        const Uints rgba = hn::Xor(hn::Xor(resolve_channels(color.x), hn::ShiftLeft<8>(resolve_channels(color.y))),
                                   hn::Xor(hn::ShiftLeft<16>(resolve_channels(color.z)), hn::Set(uints, 0xb4000000u)));
        alignas(64) uint32_t bytes[lane_count];
        hn::Store(rgba, uints, bytes);
        uint8_t *to = first_bytes + first.y * byte_stride + size_t{first.x} * 4;
        if (inside == all_lanes) {
            for (uint32_t row = 0; row < lane_count / 4; ++row, to += byte_stride) {
                __builtin_memcpy(to, bytes + row * 4, 16);
            }
        } else {
            for (uint32_t row = 0; row < lane_count / 4; ++row, to += byte_stride) {
                if (const uint32_t columns = columns_of(row, inside)) {
                    __builtin_memcpy(to, bytes + row * 4, 4 * columns);
                }
            }
        }
        if (first_light) {
            const Points radiance = colors.at(ray);
            alignas(64) float rgb[3 * lane_count];
            hn::StoreInterleaved3(radiance.x, radiance.y, radiance.z, floats, rgb);
            float *light = first_light + first.y * light_stride + size_t{first.x} * 3;
            for (uint32_t row = 0; row < lane_count / 4; ++row, light += light_stride) {
                if (const uint32_t columns = columns_of(row, inside)) {
                    __builtin_memcpy(light, rgb + row * 12, 12 * columns);
                }
            }
        }
    });
}

/// A level waits while the rays that branched off beside it are followed: one a depth at most.
HWY_INLINE size_t scratch_bytes(const KernelScene &scene, const KernelFrame &frame) {
    const size_t waiting = scene.may_branch ? frame.max_depth : 0;
    return sizeof(TileWork) + (waiting + 1) * sizeof(RayLevel);
}

/// Follows a level of rays to the end, and all that come of it.
HWY_INLINE void follow(const KernelScene &scene, const KernelFrame &frame, TileWork &work, RayLevel *waiting,
                       RayCounts &rays) {
    const bool is_plain = has_plain_surfaces(scene);
    uint32_t waiting_count = 0;
    while (true) {
        trace_level(scene.geometry, *work.level, *work.beams);
        RayLevel &branch = waiting[waiting_count];
        rays.secondary += is_plain ? reach_surfaces<true>(scene, frame.max_depth, work, branch)
                                   : reach_surfaces<false>(scene, frame.max_depth, work, branch);
        rays.shadow += add_local_colors(scene, work);
        if (!branch.selection.empty()) ++waiting_count;
        if (!work.next->selection.empty()) {
            RayLevel *const done = work.level;
            work.level = work.next;
            work.next = done;
        } else if (waiting_count > 0) {
            __builtin_memcpy(work.level, &waiting[--waiting_count], sizeof(RayLevel));
        } else {
            return;
        }
    }
}

HWY_INLINE void render_tile(const KernelScene &scene, const KernelFrame &frame, Tile tile, KernelScratch &scratch) {
    TileWork &work = *reinterpret_cast<TileWork *>(scratch.memory);
    RayLevel *const waiting = reinterpret_cast<RayLevel *>(scratch.memory + sizeof(TileWork));
    work.beams = &scratch.beams;
    work.level = &work.levels[0];
    work.next = &work.levels[1];
    work.colors.clear();
    const uint32_t sample_count = frame.samples.columns * frame.samples.rows;
    for (uint32_t sample = 0; sample < sample_count; ++sample) {
        make_primary_rays(frame, tile, sample, *work.level);
        if (HWY_UNLIKELY(scene.has_refraction)) set_eye_media(frame, *work.level);
        scratch.rays.primary += work.level->selection.count();
        follow(scene, frame, work, waiting, scratch.rays);
    }
    if (HWY_UNLIKELY(sample_count > 1)) average(sample_count, work.colors);
    const TileColors *shown = &work.colors;
    if (HWY_UNLIKELY(frame.tone_scale > 0.0f || frame.to_srgb)) {
        make_displayed(frame, work.colors, work.points.local);
        shown = &work.points.local;
    }
    resolve_tile(frame, tile, work.colors, *shown);
}

} // namespace glint::HWY_NAMESPACE
