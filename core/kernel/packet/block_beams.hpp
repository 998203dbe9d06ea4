// A beam around each block of a group: tells which blocks of rays a triangle can concern.
#pragma once

#include "kernel/packet/make_beam.hpp"

namespace glint::HWY_NAMESPACE {

/// Beams of all blocks in the axes of the group's own beam, one block a lane.
struct alignas(64) BlockBeams {
    float offset[4][block_count], slope[4][block_count];
    float z_end[block_count];

    /// Bit b for every block whose beam the triangle may enter.
    [[nodiscard]] HWY_INLINE uint32_t entered_by(const BeamAxes &axes, const float *corners) const {
        float u[3], v[3], z[3];
        for (int i = 0; i < 3; ++i) {
            u[i] = corners[3 * i + axes.u] - axes.base_u();
            v[i] = corners[3 * i + axes.v] - axes.base_v();
            z[i] = (corners[3 * i + axes.z] - axes.base_z()) * axes.sign;
        }
        const Floats z0 = splat(z[0]), z1 = splat(z[1]), z2 = splat(z[2]);
        const Floats nearest = splat(smaller(smaller(z[0], z[1]), z[2]));
        uint32_t entered = 0;
        for (uint32_t block = 0; block < block_count; block += lane_count) {
            const auto beyond = [&](int side, Floats a, Floats b, Floats c) {
                const Floats m = hn::Load(floats, slope[side] + block);
                return hn::Gt(min3(a - m * z0, b - m * z1, c - m * z2), hn::Load(floats, offset[side] + block));
            };
            const FloatMask outside = hn::Or(hn::Or(hn::Or(beyond(0, splat(-u[0]), splat(-u[1]), splat(-u[2])),
                                                           beyond(1, splat(u[0]), splat(u[1]), splat(u[2]))),
                                                    hn::Or(beyond(2, splat(-v[0]), splat(-v[1]), splat(-v[2])),
                                                           beyond(3, splat(v[0]), splat(v[1]), splat(v[2])))),
                                             hn::Gt(nearest, hn::Load(floats, z_end + block)));
            entered |= (~bits_of(outside) & all_lanes) << block;
        }
        return entered;
    }
};

/// Fills in the beams' sides. `beam` is the group's.
template <bool shares_origin> HWY_INLINE void make_block_sides(const RayGroup &rays, const RaySelection &selection,
                                                               const Beam &beam, BlockBeams &blocks) {
    const BeamAxes &axes = beam.axes;
    const float *dir_u = rays.dir_row(axes.u), *dir_v = rays.dir_row(axes.v), *dir_z = rays.dir_row(axes.z);
    const float *org_u = rays.org_row(axes.u), *org_v = rays.org_row(axes.v), *org_z = rays.org_row(axes.z);
    const Floats sign = splat(axes.sign), minus_infinity = splat(-__builtin_inff());
    const float widening = beam.slack * (1.0f + steepest_slope);
    for (uint32_t block = 0; block < block_count; ++block) {
        const uint32_t bits = selection.blocks[block];
        if (bits == 0) {
            for (int i = 0; i < 4; ++i) blocks.offset[i][block] = blocks.slope[i][block] = 0.0f;
            continue;
        }
        Floats most[4] = {minus_infinity, minus_infinity, minus_infinity, minus_infinity};
        for (uint32_t part = 0; part < block_size; part += lane_count) {
            const FloatMask lanes = mask_of((bits >> part) & all_lanes);
            const uint32_t ray = block * block_size + part;
            const Floats inverse = splat(1.0f) / (hn::Load(floats, dir_z + ray) * sign);
            const Floats su = hn::Load(floats, dir_u + ray) * inverse, sv = hn::Load(floats, dir_v + ray) * inverse;
            most[0] = hn::Max(most[0], hn::IfThenElse(lanes, hn::Neg(su), minus_infinity));
            most[1] = hn::Max(most[1], hn::IfThenElse(lanes, su, minus_infinity));
            most[2] = hn::Max(most[2], hn::IfThenElse(lanes, hn::Neg(sv), minus_infinity));
            most[3] = hn::Max(most[3], hn::IfThenElse(lanes, sv, minus_infinity));
        }
        float slopes[4];
        for (int i = 0; i < 4; ++i) blocks.slope[i][block] = slopes[i] = greatest_lane(most[i]);
        if constexpr (shares_origin) {
            for (int i = 0; i < 4; ++i) blocks.offset[i][block] = widening;
        } else {
            for (Floats &m : most) m = minus_infinity;
            for (uint32_t part = 0; part < block_size; part += lane_count) {
                const FloatMask lanes = mask_of((bits >> part) & all_lanes);
                const uint32_t ray = block * block_size + part;
                const Floats u = hn::Load(floats, org_u + ray) - splat(axes.base_u()),
                             v = hn::Load(floats, org_v + ray) - splat(axes.base_v()),
                             z = (hn::Load(floats, org_z + ray) - splat(axes.base_z())) * sign;
                const auto side = [&](int i, Floats across) {
                    most[i] = hn::Max(most[i], hn::IfThenElse(lanes, across - splat(slopes[i]) * z, minus_infinity));
                };
                side(0, hn::Neg(u));
                side(1, u);
                side(2, hn::Neg(v));
                side(3, v);
            }
            for (int i = 0; i < 4; ++i) blocks.offset[i][block] = greatest_lane(most[i]) + widening;
        }
    }
}

/// How far the rays of some lanes may still go, as depth along the beam.
template <bool shares_origin>
HWY_INLINE Floats ends_of(const RayGroup &rays, uint32_t ray, uint32_t lane_bits, const BeamAxes &axes) {
    const Floats t = hn::Load(floats, rays.t + ray) * splat(1.0f + distance_error);
    Floats z = t * hn::Load(floats, rays.dir_row(axes.z) + ray);
    if constexpr (!shares_origin) z = z + (hn::Load(floats, rays.org_row(axes.z) + ray) - splat(axes.base_z()));
    return hn::IfThenElse(mask_of(lane_bits), z * splat(axes.sign), splat(-__builtin_inff()));
}

/// The same for all selected rays of a block, and of a group.
template <bool shares_origin>
HWY_INLINE float block_end(const RayGroup &rays, uint32_t block, uint32_t bits, const Beam &beam) {
    Floats end = splat(-__builtin_inff());
    for (uint32_t part = 0; part < block_size; part += lane_count) {
        end = hn::Max(end,
                      ends_of<shares_origin>(rays, block * block_size + part, (bits >> part) & all_lanes, beam.axes));
    }
    return greatest_lane(end) + beam.slack;
}
template <bool shares_origin>
HWY_INLINE float group_end(const RayGroup &rays, const RaySelection &selection, const Beam &beam) {
    Floats end = splat(-__builtin_inff());
    for_each_vector(selection, [&](uint32_t ray, uint32_t lane_bits) {
        end = hn::Max(end, ends_of<shares_origin>(rays, ray, lane_bits, beam.axes));
    });
    return greatest_lane(end) + beam.slack;
}

} // namespace glint::HWY_NAMESPACE
