// Finds the beam around a group of rays.
#pragma once

#include "kernel/packet/apex.hpp"

namespace glint::HWY_NAMESPACE {

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

    const float *org_u = rays.org_row(axes.u), *org_v = rays.org_row(axes.v), *org_z = rays.org_row(axes.z);
    const Floats base_u = splat(axes.base_u()), base_v = splat(axes.base_v()), base_z = splat(axes.base_z());
    const ApexGuess apex = shares_origin ? ApexGuess{} : guess_apex(rays, selection, axes);
    const Floats apex_u = splat(apex.u), apex_v = splat(apex.v), apex_z = splat(apex.z);

    Floats least_dz = infinity, dir_reach = hn::Zero(floats), spread = hn::Zero(floats), z_begin = infinity;
    Floats u_lo = infinity, u_hi = hn::Neg(infinity), v_lo = infinity, v_hi = hn::Neg(infinity);
    Floats miss = hn::Zero(floats);
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
        if constexpr (!shares_origin) {
            const Floats u = hn::Load(floats, org_u + ray) - base_u, v = hn::Load(floats, org_v + ray) - base_v,
                         z = (hn::Load(floats, org_z + ray) - base_z) * sign;
            z_begin = hn::Min(z_begin, hn::IfThenElse(lanes, z, infinity));
            spread = hn::Max(spread, hn::IfThenElseZero(lanes, max3(hn::Abs(u), hn::Abs(v), hn::Abs(z))));
            const Floats way = apex_z - z;
            const Floats off = hn::Max(hn::Abs((u - apex_u) + su * way), hn::Abs((v - apex_v) + sv * way));
            miss = hn::Max(miss, hn::IfThenElseZero(lanes, off));
        }
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
    const float scene_reach = reach_of(scene_bounds, base);
    if constexpr (shares_origin) {
        beam.slack = 0x1p-20f * scene_reach;
        for (float &offset : beam.offset) offset = beam.slack * (1.0f + steepest);
        beam.z_begin = -beam.slack;
        beam.apex = base;
        beam.apex_miss = 0.0f;
        return true;
    }
    beam.slack = 0x1p-20f * (scene_reach + greatest_lane(spread));
    beam.z_begin = least_lane(z_begin) - beam.slack;
    if (set_apex(beam, apex, greatest_lane(miss))) return true;
    // A side passes each origin at z = 0 as if it ran back from there with the beam's own slope.
    Floats sides[4] = {hn::Neg(infinity), hn::Neg(infinity), hn::Neg(infinity), hn::Neg(infinity)};
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
    });
    for (int i = 0; i < 4; ++i) beam.offset[i] = greatest_lane(sides[i]) + beam.slack * (1.0f + steepest);
    return true;
}

/// No beam at all: just how long the selected rays' directions are, and how far everything is.
HWY_INLINE Beam unbounded_beam(const RayGroup &rays, const RaySelection &selection, const Box &scene_bounds) {
    const Box &b = scene_bounds;
    const Points lo = splat({b.lo.x, b.lo.y, b.lo.z}), hi = splat({b.hi.x, b.hi.y, b.hi.z});
    Floats dir_reach = hn::Zero(floats), reach = hn::Zero(floats);
    for_each_vector(selection, [&](uint32_t ray, uint32_t lane_bits) {
        const FloatMask lanes = mask_of(lane_bits);
        const Points org = rays.org(ray);
        const Floats farthest = hn::Max(max_abs(difference(lo, org)), max_abs(difference(hi, org)));
        dir_reach = hn::IfThenElse(lanes, hn::Max(dir_reach, max_abs(rays.dir(ray))), dir_reach);
        reach = hn::IfThenElse(lanes, hn::Max(reach, farthest), reach);
    });
    Beam beam{};
    beam.dir_reach = greatest_lane(dir_reach);
    beam.slack = 0x1p-20f * greatest_lane(reach);
    beam.apex_miss = -1.0f;
    return beam;
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

/// Gathers the ways from a shared origin to the rays' ends. An end is taken a little beyond its t_max, by 4 eps: see
/// GroupTest::all_end_before().
class WayBounds {
public:
    HWY_INLINE void extend(FloatMask lanes, const Points &dir, Floats t_max) {
        const Points way = scaled(dir, t_max * splat(1.0f + 0x1p-22f));
        const auto extend = [lanes](Floats &low, Floats &high, Floats w) {
            // In this order: a way that is no number (0 times infinity) must not wipe out the others'.
            low = hn::IfThenElse(lanes, hn::Min(w, low), low);
            high = hn::IfThenElse(lanes, hn::Max(w, high), high);
        };
        extend(lo_.x, hi_.x, way.x);
        extend(lo_.y, hi_.y, way.y);
        extend(lo_.z, hi_.z, way.z);
    }
    [[nodiscard]] HWY_INLINE RayEnds ends(const Point3 &org, float least_t_max) const {
        RayEnds ends;
        const Floats lows[3] = {lo_.x, lo_.y, lo_.z}, highs[3] = {hi_.x, hi_.y, hi_.z};
        for (int axis = 0; axis < 3; ++axis) {
            ends.way_lo[axis] = least_lane(lows[axis]);
            ends.way_hi[axis] = greatest_lane(highs[axis]);
        }
        ends.lo = {org.x + ends.way_lo[0], org.y + ends.way_lo[1], org.z + ends.way_lo[2]};
        ends.hi = {org.x + ends.way_hi[0], org.y + ends.way_hi[1], org.z + ends.way_hi[2]};
        ends.reach = larger(max_abs(ends.lo), max_abs(ends.hi));
        ends.way = larger(max_abs(Point3{ends.way_lo[0], ends.way_lo[1], ends.way_lo[2]}),
                          max_abs(Point3{ends.way_hi[0], ends.way_hi[1], ends.way_hi[2]}));
        ends.least_t_max = least_t_max;
        return ends;
    }

private:
    Points lo_ = splat(Point3{__builtin_inff(), __builtin_inff(), __builtin_inff()});
    Points hi_ = splat(Point3{-__builtin_inff(), -__builtin_inff(), -__builtin_inff()});
};

/// Of the selected rays, of which there is at least one.
HWY_INLINE RayEnds find_ends(const RayGroup &rays, const RaySelection &selection) {
    WayBounds ways;
    Floats least_t = splat(__builtin_inff());
    for_each_vector(selection, [&](uint32_t ray, uint32_t lane_bits) {
        const FloatMask lanes = mask_of(lane_bits);
        const Floats t = hn::Load(floats, rays.t + ray);
        least_t = hn::IfThenElse(lanes, hn::Min(least_t, t), least_t);
        ways.extend(lanes, rays.dir(ray), t);
    });
    return ways.ends(rays.shared_origin, least_lane(least_t));
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

} // namespace glint::HWY_NAMESPACE
