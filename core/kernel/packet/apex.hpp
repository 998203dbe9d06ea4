// Rays that do not start at one point, but all seem to come from one: those of a pinhole camera that a flat mirror has
// thrown back. What is true of rays from one point is then nearly true of them, and the difference can be bounded.
#pragma once

#include "kernel/packet/beam.hpp"

namespace glint::HWY_NAMESPACE {

/// A beam has no apex farther away than this many times its reach, nor one that is missed by a larger part of it.
inline constexpr float farthest_apex = 64.0f, widest_apex = 0x1p-12f;

/// A point that may be an apex, in a beam's coordinates.
struct ApexGuess {
    float u = 0.0f, v = 0.0f, z = 0.0f;
};

/// Where the lines of the first and of the last selected ray meet, if anywhere. The point's coordinates in space are
/// floats too.
HWY_INLINE ApexGuess guess_apex(const RayGroup &rays, const RaySelection &selection, const BeamAxes &axes) {
    const uint32_t first = first_ray_of(selection), last = last_ray_of(selection);
    const auto slope = [&](int axis, uint32_t ray) {
        return rays.dir_row(axis)[ray] / (rays.dir_row(axes.z)[ray] * axes.sign);
    };
    // The first ray starts at the origin.
    const float u = rays.org_row(axes.u)[last] - axes.base_u(), v = rays.org_row(axes.v)[last] - axes.base_v(),
                z = (rays.org_row(axes.z)[last] - axes.base_z()) * axes.sign;
    const float first_u = slope(axes.u, first), first_v = slope(axes.v, first);
    const float last_u = slope(axes.u, last), last_v = slope(axes.v, last);
    const bool by_u = magnitude(first_u - last_u) > magnitude(first_v - last_v);
    const float depth = by_u ? (u - last_u * z) / (first_u - last_u) : (v - last_v * z) / (first_v - last_v);
    const auto as_in_space = [](float base, float way) { return (base + way) - base; };
    return {as_in_space(axes.base_u(), first_u * depth), as_in_space(axes.base_v(), first_v * depth),
            as_in_space(axes.base_z(), depth * axes.sign) * axes.sign};
}

/// Gives a beam, complete but for its offsets, the apex and the sides through it; `miss` is how far off the selected
/// rays' lines pass. False where it is none, or not behind all rays.
HWY_INLINE bool set_apex(Beam &beam, const ApexGuess &apex, float miss) {
    const BeamAxes &axes = beam.axes;
    const float reach = beam.slack * 0x1p20f, steepest = beam.steepest();
    beam.apex_miss = -1.0f;
    if (!(apex.z <= beam.z_begin && apex.z > -farthest_apex * reach)) return false;
    // What is added covers the rounding: less than 8 eps of all lengths that were added up.
    miss += 0x1p-20f * (1.0f + steepest) * (reach - apex.z);
    if (!(miss < widest_apex * reach)) return false;
    float point[3];
    point[axes.u] = axes.base_u() + apex.u;
    point[axes.v] = axes.base_v() + apex.v;
    point[axes.z] = axes.base_z() + apex.z * axes.sign;
    beam.apex = {point[0], point[1], point[2]};
    beam.apex_miss = miss;
    const float across[4] = {-apex.u, apex.u, -apex.v, apex.v};
    for (int i = 0; i < 4; ++i) {
        beam.offset[i] = (across[i] - beam.slope[i] * apex.z) + miss + beam.slack * (1.0f + steepest);
    }
    return true;
}

} // namespace glint::HWY_NAMESPACE
