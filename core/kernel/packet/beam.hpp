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
    /// Whether all directions have the same signs, but for rounding.
    [[nodiscard]] HWY_INLINE bool has_one_octant() const {
        return (slope[0] < 0.0f || slope[1] < 0.0f) && (slope[2] < 0.0f || slope[3] < 0.0f);
    }
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
