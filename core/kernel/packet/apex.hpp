// Rays that do not start at one point, but all seem to come from one: those of a pinhole camera that a flat mirror has
// thrown back. What is true of rays from one point is then nearly true of them, and the difference can be bounded.
#pragma once

#include "kernel/packet/beam.hpp"

namespace glint::HWY_NAMESPACE {

/// A beam has no apex farther away than this many times its reach, nor one that is missed by a larger part of it.
inline constexpr float farthest_apex = 64.0f, widest_apex = 0x1p-12f;

/// A ray in a beam's coordinates, all lengths from the beam's base.
struct BeamRay {
    float u, v, z, slope_u, slope_v;

    HWY_INLINE BeamRay(const RayGroup &rays, uint32_t ray, const BeamAxes &axes)
        : u(rays.org_row(axes.u)[ray] - axes.base_u()),
          v(rays.org_row(axes.v)[ray] - axes.base_v()),
          z((rays.org_row(axes.z)[ray] - axes.base_z()) * axes.sign),
          slope_u(rays.dir_row(axes.u)[ray] / (rays.dir_row(axes.z)[ray] * axes.sign)),
          slope_v(rays.dir_row(axes.v)[ray] / (rays.dir_row(axes.z)[ray] * axes.sign)) {}
};

/// How far off the apex (in the beam's coordinates) the selected rays' lines pass, at the apex's depth.
HWY_INLINE float largest_miss(const RayGroup &rays, const RaySelection &selection, const BeamAxes &axes,
                              const float *apex) {
    const Floats base_u = splat(axes.base_u()), base_v = splat(axes.base_v()), base_z = splat(axes.base_z()),
                 sign = splat(axes.sign), u = splat(apex[0]), v = splat(apex[1]), z = splat(apex[2]);
    const float *org_u = rays.org_row(axes.u), *org_v = rays.org_row(axes.v), *org_z = rays.org_row(axes.z);
    const float *dir_u = rays.dir_row(axes.u), *dir_v = rays.dir_row(axes.v), *dir_z = rays.dir_row(axes.z);
    Floats largest = hn::Zero(floats);
    for_each_vector(selection, [&](uint32_t ray, uint32_t lanes) {
        const Floats way =
            (z - (hn::Load(floats, org_z + ray) - base_z) * sign) / (hn::Load(floats, dir_z + ray) * sign);
        const Floats off_u = (hn::Load(floats, org_u + ray) - base_u - u) + hn::Load(floats, dir_u + ray) * way;
        const Floats off_v = (hn::Load(floats, org_v + ray) - base_v - v) + hn::Load(floats, dir_v + ray) * way;
        largest = hn::Max(largest, hn::IfThenElseZero(mask_of(lanes), hn::Max(hn::Abs(off_u), hn::Abs(off_v))));
    });
    return greatest_lane(largest);
}

/// Gives the beam an apex: where the lines of its first and its last ray meet, if all others pass there too. False
/// where there is none.
HWY_INLINE bool find_apex(const RayGroup &rays, const RaySelection &selection, Beam &beam) {
    const BeamAxes &axes = beam.axes;
    const BeamRay first(rays, first_ray_of(selection), axes), last(rays, last_ray_of(selection), axes);
    const float apart_u = first.slope_u - last.slope_u, apart_v = first.slope_v - last.slope_v;
    const bool by_u = magnitude(apart_u) > magnitude(apart_v);
    const float apart = by_u ? apart_u : apart_v;
    const float depth = (by_u ? last.u - last.slope_u * last.z : last.v - last.slope_v * last.z) / apart;
    const float reach = beam.slack * 0x1p20f;
    if (!(magnitude(depth) < farthest_apex * reach)) return false;
    // As a point of space, rounded, and back again.
    float point[3];
    point[axes.u] = axes.base_u() + first.slope_u * depth;
    point[axes.v] = axes.base_v() + first.slope_v * depth;
    point[axes.z] = axes.base_z() + depth * axes.sign;
    const float apex[3] = {point[axes.u] - axes.base_u(), point[axes.v] - axes.base_v(),
                           (point[axes.z] - axes.base_z()) * axes.sign};
    // What is added covers the rounding in largest_miss(): less than 8 eps of what it adds up.
    const float miss =
        largest_miss(rays, selection, axes, apex) + 0x1p-20f * (1.0f + beam.steepest()) * (reach + magnitude(apex[2]));
    if (!(miss < widest_apex * reach)) return false;
    beam.apex = {point[0], point[1], point[2]};
    beam.apex_miss = miss;
    return true;
}

} // namespace glint::HWY_NAMESPACE
