// A beam: the space that a group of rays may pass through, bounded by four planes.
#pragma once

#include "accel/kd_tree.hpp"
#include "kernel/intersect.hpp"
#include "kernel/packet/ray_group.hpp"

namespace glint::HWY_NAMESPACE {

/// Coordinates in which all rays of a beam run towards larger z: z is the world axis along which they mostly go, turned
/// round where `sign` is -1; u and v are the other two; the origin is near the rays' own.
struct BeamAxes {
    int u, v, z;
    float sign;
    Point3 base;

    [[nodiscard]] HWY_INLINE float base_u() const { return coordinate(base, u); }
    [[nodiscard]] HWY_INLINE float base_v() const { return coordinate(base, v); }
    [[nodiscard]] HWY_INLINE float base_z() const { return coordinate(base, z); }
};

/// A direction's axes: z is its largest component's.
HWY_INLINE BeamAxes axes_along(float x, float y, float z, const Point3 &base) {
    const float ax = magnitude(x), ay = magnitude(y), az = magnitude(z);
    if (ax >= ay && ax >= az) return {1, 2, 0, x < 0.0f ? -1.0f : 1.0f, base};
    if (ay >= az) return {2, 0, 1, y < 0.0f ? -1.0f : 1.0f, base};
    return {0, 1, 2, z < 0.0f ? -1.0f : 1.0f, base};
}

/// -u <= side[0], u <= side[1], -v <= side[2], v <= side[3] at depth z, where side[i] = offset[i] + slope[i] * z: true
/// of every point of every ray, since a ray that starts inside and is less steep than a side stays inside. For planes
/// that bound several rays that way see Reshetov, Soupikov & Hurley 2005 ("Multi-level ray tracing algorithm") and
/// Dmitriev, Havran & Seidel 2004 ("Faster ray tracing with SIMD shaft culling").
struct Beam {
    BeamAxes axes;
    float offset[4], slope[4];
    float z_begin;   ///< no ray starts before
    float z_end;     ///< no ray goes farther
    float dir_reach; ///< largest coordinate of a direction
    float slack;     ///< see prepared_ray.hpp; contained in the offsets
    Point3 apex;     ///< the point that all rays start from or seem to come from, if there is one: see apex.hpp
    float apex_miss; ///< no ray's line passes the apex farther off, in its plane across z; negative without an apex

    [[nodiscard]] HWY_INLINE bool has_apex() const { return apex_miss >= 0.0f; }
    [[nodiscard]] HWY_INLINE float steepest() const {
        return larger(larger(magnitude(slope[0]), magnitude(slope[1])),
                      larger(magnitude(slope[2]), magnitude(slope[3])));
    }
};

/// The four directions between which all rays of a beam lie, repeated over the lanes.
HWY_INLINE Points corner_directions(const Beam &beam) {
    alignas(64) float rows[3][lane_count];
    for (uint32_t lane = 0; lane < lane_count; ++lane) {
        rows[beam.axes.u][lane] = lane % 2 == 0 ? -beam.slope[0] : beam.slope[1];
        rows[beam.axes.v][lane] = lane / 2 % 2 == 0 ? -beam.slope[2] : beam.slope[3];
        rows[beam.axes.z][lane] = beam.axes.sign;
    }
    return {hn::Load(floats, rows[0]), hn::Load(floats, rows[1]), hn::Load(floats, rows[2])};
}
/// The largest coordinate of one of those.
HWY_INLINE float corner_reach(const Beam &beam) {
    return larger(1.0f, beam.steepest());
}

/// Beams steeper than this against their own axis are not worth making.
inline constexpr float steepest_slope = 6.0f;

/// Largest distance, by coordinate, between a point and a box.
HWY_INLINE float reach_of(const Box &box, const Point3 &p) {
    const float x = larger(magnitude(box.lo.x - p.x), magnitude(box.hi.x - p.x));
    const float y = larger(magnitude(box.lo.y - p.y), magnitude(box.hi.y - p.y));
    const float z = larger(magnitude(box.lo.z - p.z), magnitude(box.hi.z - p.z));
    return larger(larger(x, y), z);
}

/// Which ray of a selection comes first.
HWY_INLINE uint32_t first_ray_of(const RaySelection &selection) {
    uint32_t block = 0;
    while (selection.blocks[block] == 0) ++block;
    return block * block_size + lowest_bit(selection.blocks[block]);
}

/// Which comes last.
HWY_INLINE uint32_t last_ray_of(const RaySelection &selection) {
    uint32_t block = block_count - 1;
    while (selection.blocks[block] == 0) --block;
    return block * block_size + (31 - static_cast<uint32_t>(__builtin_clz(selection.blocks[block])));
}

/// The beam around the selected rays, of which there is at least one. False where they do not go one way.
template <bool shares_origin>
HWY_INLINE bool make_beam(const RayGroup &rays, const RaySelection &selection, const Box &scene_bounds, Beam &beam) {
    const uint32_t first = first_ray_of(selection);
    const Point3 base =
        shares_origin ? rays.shared_origin : Point3{rays.org_x[first], rays.org_y[first], rays.org_z[first]};
    beam.axes = axes_along(rays.dir_x[first], rays.dir_y[first], rays.dir_z[first], base);
    const BeamAxes &axes = beam.axes;
    const float *dir_u = rays.dir_row(axes.u), *dir_v = rays.dir_row(axes.v), *dir_z = rays.dir_row(axes.z);
    const Floats sign = splat(axes.sign), infinity = splat(__builtin_inff());

    Floats least_dz = infinity, dir_reach = hn::Zero(floats);
    Floats u_lo = infinity, u_hi = hn::Neg(infinity), v_lo = infinity, v_hi = hn::Neg(infinity);
    for_each_vector(selection, [&](uint32_t ray, uint32_t lane_bits) {
        const FloatMask lanes = mask_of(lane_bits);
        const Floats du = hn::Load(floats, dir_u + ray), dv = hn::Load(floats, dir_v + ray);
        const Floats dz = hn::IfThenElse(lanes, hn::Load(floats, dir_z + ray) * sign, infinity);
        least_dz = hn::Min(least_dz, dz);
        const Floats inverse = splat(1.0f) / dz;
        const Floats su = du * inverse, sv = dv * inverse;
        u_lo = hn::Min(u_lo, hn::IfThenElse(lanes, su, infinity));
        v_lo = hn::Min(v_lo, hn::IfThenElse(lanes, sv, infinity));
        u_hi = hn::Max(u_hi, hn::IfThenElse(lanes, su, hn::Neg(infinity)));
        v_hi = hn::Max(v_hi, hn::IfThenElse(lanes, sv, hn::Neg(infinity)));
        const Floats largest = max3(hn::Abs(du), hn::Abs(dv), hn::IfThenElseZero(lanes, dz));
        dir_reach = hn::Max(dir_reach, hn::IfThenElseZero(lanes, largest));
    });
    if (!(least_lane(least_dz) > 0.0f)) return false;
    beam.slope[0] = -least_lane(u_lo);
    beam.slope[1] = greatest_lane(u_hi);
    beam.slope[2] = -least_lane(v_lo);
    beam.slope[3] = greatest_lane(v_hi);
    const float steepest = beam.steepest();
    if (!(steepest <= steepest_slope)) return false;
    beam.dir_reach = greatest_lane(dir_reach);
    beam.z_end = __builtin_inff();
    beam.apex = base;
    beam.apex_miss = shares_origin ? 0.0f : -1.0f;

    if constexpr (shares_origin) {
        beam.slack = 0x1p-20f * reach_of(scene_bounds, base);
        for (float &offset : beam.offset) offset = beam.slack * (1.0f + steepest);
        beam.z_begin = -beam.slack;
    } else {
        // A side passes each origin at z = 0 as if it ran back from there with the beam's own slope.
        const float *org_u = rays.org_row(axes.u), *org_v = rays.org_row(axes.v), *org_z = rays.org_row(axes.z);
        const Floats base_u = splat(axes.base_u()), base_v = splat(axes.base_v()), base_z = splat(axes.base_z());
        Floats sides[4] = {hn::Neg(infinity), hn::Neg(infinity), hn::Neg(infinity), hn::Neg(infinity)};
        Floats spread = hn::Zero(floats), z_begin = infinity;
        for_each_vector(selection, [&](uint32_t ray, uint32_t lane_bits) {
            const FloatMask lanes = mask_of(lane_bits);
            const Floats u = hn::Load(floats, org_u + ray) - base_u, v = hn::Load(floats, org_v + ray) - base_v,
                         z = (hn::Load(floats, org_z + ray) - base_z) * sign;
            const auto side = [&](int i, Floats across) {
                sides[i] = hn::Max(sides[i], hn::IfThenElse(lanes, across - splat(beam.slope[i]) * z, sides[i]));
            };
            side(0, hn::Neg(u));
            side(1, u);
            side(2, hn::Neg(v));
            side(3, v);
            z_begin = hn::Min(z_begin, hn::IfThenElse(lanes, z, infinity));
            spread = hn::Max(spread, hn::IfThenElseZero(lanes, max3(hn::Abs(u), hn::Abs(v), hn::Abs(z))));
        });
        beam.slack = 0x1p-20f * (reach_of(scene_bounds, base) + greatest_lane(spread));
        beam.z_begin = least_lane(z_begin) - beam.slack;
        for (int i = 0; i < 4; ++i) beam.offset[i] = greatest_lane(sides[i]) + beam.slack * (1.0f + steepest);
    }
    return true;
}

/// The beam of primary rays through a full tile's pixels, all of unit length: on a flat window the steepest rays are
/// those through the corners.
HWY_INLINE bool make_tile_beam(const RayGroup &rays, const Box &scene_bounds, Beam &beam) {
    RaySelection corners{};
    corners.blocks[0] = 1u << 0;
    corners.blocks[3] = 1u << 3;
    corners.blocks[12] = 1u << 12;
    corners.blocks[15] = 1u << 15;
    if (!make_beam<true>(rays, corners, scene_bounds, beam)) return false;
    beam.dir_reach = 1.0f + 0x1p-20f;
    return true;
}

/// Where rays with one origin end.
struct RayEnds {
    Point3 lo, hi;     ///< box around org + t_max * dir
    float reach;       ///< largest coordinate of an end
    float way;         ///< largest coordinate of t_max * dir
    float least_t_max; ///< of the rays
    float way_lo[3], way_hi[3];
};

/// A ray's end is taken a little beyond its t_max, by 4 eps: see GroupTrace::all_end_before().
HWY_INLINE RayEnds find_ends(const RayGroup &rays, const RaySelection &selection) {
    const uint32_t first = first_ray_of(selection);
    const Floats first_t = splat(rays.t[first]);
    const Points first_dir = splat({rays.dir_x[first], rays.dir_y[first], rays.dir_z[first]});
    const Floats infinity = splat(__builtin_inff());
    Points lo = {infinity, infinity, infinity}, hi = {hn::Neg(infinity), hn::Neg(infinity), hn::Neg(infinity)};
    Floats least_t = first_t;
    for_each_vector(selection, [&](uint32_t ray, uint32_t lane_bits) {
        const FloatMask lanes = mask_of(lane_bits);
        const Points dir = rays.dir(ray);
        const Floats t = hn::IfThenElse(lanes, hn::Load(floats, rays.t + ray), first_t);
        const Floats beyond = t * splat(1.0f + 0x1p-22f);
        least_t = hn::Min(least_t, t);
        const auto extend = [&](Floats &low, Floats &high, Floats d, Floats first_d) {
            const Floats way = hn::IfThenElse(lanes, d, first_d) * beyond;
            low = hn::Min(low, way);
            high = hn::Max(high, way);
        };
        extend(lo.x, hi.x, dir.x, first_dir.x);
        extend(lo.y, hi.y, dir.y, first_dir.y);
        extend(lo.z, hi.z, dir.z, first_dir.z);
    });
    RayEnds ends;
    const Floats lows[3] = {lo.x, lo.y, lo.z}, highs[3] = {hi.x, hi.y, hi.z};
    for (int axis = 0; axis < 3; ++axis) {
        ends.way_lo[axis] = least_lane(lows[axis]);
        ends.way_hi[axis] = greatest_lane(highs[axis]);
    }
    const Point3 &org = rays.shared_origin;
    ends.lo = {org.x + ends.way_lo[0], org.y + ends.way_lo[1], org.z + ends.way_lo[2]};
    ends.hi = {org.x + ends.way_hi[0], org.y + ends.way_hi[1], org.z + ends.way_hi[2]};
    ends.reach = larger(max_abs(ends.lo), max_abs(ends.hi));
    ends.way = larger(max_abs(Point3{ends.way_lo[0], ends.way_lo[1], ends.way_lo[2]}),
                      max_abs(Point3{ends.way_hi[0], ends.way_hi[1], ends.way_hi[2]}));
    ends.least_t_max = least_lane(least_t);
    return ends;
}

/// The beam from a point to the box around the rays' ends: quicker made than the closest one, and hardly wider where
/// the ends lie on a surface that a tile sees.
HWY_INLINE bool make_end_beam(const RayGroup &rays, const RayEnds &ends, const Box &scene_bounds, Beam &beam) {
    beam.axes = axes_along(ends.way_lo[0] + ends.way_hi[0], ends.way_lo[1] + ends.way_hi[1],
                           ends.way_lo[2] + ends.way_hi[2], rays.shared_origin);
    const BeamAxes &axes = beam.axes;
    const bool turned = axes.sign < 0.0f;
    const float nearest = turned ? -ends.way_hi[axes.z] : ends.way_lo[axes.z];
    const float farthest = turned ? -ends.way_lo[axes.z] : ends.way_hi[axes.z];
    if (!(nearest > 0.0f) || !(ends.least_t_max > 0.0f)) return false;
    const float by_nearest = 1.0f / nearest, by_farthest = 1.0f / farthest;
    const auto slope = [&](float across) { return across * (across > 0.0f ? by_nearest : by_farthest); };
    beam.slope[0] = slope(-ends.way_lo[axes.u]);
    beam.slope[1] = slope(ends.way_hi[axes.u]);
    beam.slope[2] = slope(-ends.way_lo[axes.v]);
    beam.slope[3] = slope(ends.way_hi[axes.v]);
    const float steepest = beam.steepest();
    if (!(steepest <= steepest_slope)) return false;
    beam.dir_reach = ends.way / ends.least_t_max;
    beam.slack = 0x1p-20f * reach_of(scene_bounds, rays.shared_origin);
    for (float &offset : beam.offset) offset = beam.slack * (1.0f + steepest);
    beam.z_begin = -beam.slack;
    beam.apex = rays.shared_origin;
    beam.apex_miss = 0.0f;
    beam.z_end = farthest + farthest * distance_error + beam.slack;
    return true;
}

/// Corners of lane_count triangles in a beam's coordinates.
struct BeamCorners {
    Floats u[3], v[3], z[3];

    /// The triangles from number i of a leaf on.
    HWY_INLINE BeamCorners(const BeamAxes &axes, const uint32_t *leaf_words, uint32_t count, uint32_t i) {
        const Floats base_u = splat(axes.base_u()), base_v = splat(axes.base_v()), base_z = splat(axes.base_z()),
                     sign = splat(axes.sign);
        for (int corner = 0; corner < 3; ++corner) {
            const auto row = [&](int axis) {
                return hn::BitCast(floats, hn::LoadU(uints, leaf_words + (3 * corner + axis) * count + i));
            };
            u[corner] = row(axes.u) - base_u;
            v[corner] = row(axes.v) - base_v;
            z[corner] = (row(axes.z) - base_z) * sign;
        }
    }
};

/// Lanes whose triangle may have a point in the beam.
HWY_INLINE uint32_t triangles_in_beam(const Beam &beam, const BeamCorners &c) {
    const auto beyond = [&](int side, Floats a, Floats b, Floats d) {
        const Floats slope = splat(beam.slope[side]);
        return hn::Gt(min3(a - slope * c.z[0], b - slope * c.z[1], d - slope * c.z[2]), splat(beam.offset[side]));
    };
    const FloatMask outside = hn::Or(hn::Or(beyond(1, c.u[0], c.u[1], c.u[2]), beyond(3, c.v[0], c.v[1], c.v[2])),
                                     hn::Or(beyond(0, hn::Neg(c.u[0]), hn::Neg(c.u[1]), hn::Neg(c.u[2])),
                                            beyond(2, hn::Neg(c.v[0]), hn::Neg(c.v[1]), hn::Neg(c.v[2]))));
    const FloatMask outside_z = hn::Or(hn::Gt(min3(c.z[0], c.z[1], c.z[2]), splat(beam.z_end)),
                                       hn::Lt(max3(c.z[0], c.z[1], c.z[2]), splat(beam.z_begin)));
    return ~bits_of(hn::Or(outside, outside_z)) & all_lanes;
}

} // namespace glint::HWY_NAMESPACE
