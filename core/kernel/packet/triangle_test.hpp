// One triangle against many rays: a float filter, and the distance of intersect.hpp, lane by lane.
#pragma once

#include "kernel/exact.hpp"
#include "kernel/packet/ray_group.hpp"

namespace glint::HWY_NAMESPACE {

/// With s = org - a, n = e1 x e2, a ray meets the triangle's plane at a + U e1 + V e2 where
///     U (n . dir) = dir . (s x e2) = e2 . (dir x s),   V (n . dir) = dir . (e1 x s) = -e1 . (dir x s),   W = 1 - U - V
/// (Moller & Trumbore 1997). All three numerators above their error, or all below minus it: certainly inside, and not
/// seen edge on. One above and one below: certainly outside. All else is for exact_distance().
///
/// The error, by counting every rounding from the corners on, with eps = 2^-24 and all lengths in the maximum norm:
///  - from one point, cross products in double, rounded once: 10 eps |dir| |e| |s| for U and V, 10 eps |dir| |e|^2 for
///    n . dir, hence 26 eps |dir| |e| (|s| + |e|) for W;
///  - along a line that passes the point a distance m off, in the plane across z, with |dir_u|, |dir_v| <= k dir_z: U
///  and
///    V by 2 (1 + k) m |e| dir_z besides, W by twice that;
///  - from anywhere, with q = dir x s: each component of q is off by 4 eps |dir| |s| + eps |q|, U and V by
///    |e| (12 eps |dir| |s| + 6 eps sum|q|), and n . dir, cross product in float, by 40 eps |dir| |e|^2;
///  - from one point, cross products in float: 33 eps |dir| |e| |s| for U and V, 40 eps |dir| |e|^2 for n . dir and as
///    much with s for n . s, hence 84 eps |dir| |e| (|s| + |e|) for W.
inline constexpr float from_point_error = 32 * 0x1p-24f;
inline constexpr float from_anywhere_error = 28 * 0x1p-24f;       ///< times |dir| |e| (|s| + 2 |e|)
inline constexpr float from_anywhere_cross_error = 16 * 0x1p-24f; ///< times |e| sum|q|
inline constexpr float float_point_error = 96 * 0x1p-24f;         ///< times |dir| |e| (|s| + |e|)
/// Of n . x, with n in float, times |x| |e|^2. What is seen edge on has less (see least_det).
inline constexpr float float_plane_error = 48 * 0x1p-24f;
/// Added to the margin: covers what is lost where products fall below the smallest normal float.
inline constexpr float least_margin = 0x1p-120f;

/// A triangle out of its leaf.
struct TriangleSetup {
    float corners[9];
    Point3 e1, e2;
    float edge_reach; ///< largest coordinate of e1 and e2
    uint32_t id;

    HWY_INLINE TriangleSetup(const uint32_t *leaf_words, uint32_t count, uint32_t i) {
        // Pointers rather than places: gcc 12 makes vectors of places, and takes them out one by one.
        const uint32_t *word = leaf_words + i;
        for (uint32_t row = 0; row < 9; ++row, word += count) __builtin_memcpy(&corners[row], word, 4);
        id = *word;
        e1 = {corners[3] - corners[0], corners[4] - corners[1], corners[5] - corners[2]};
        e2 = {corners[6] - corners[0], corners[7] - corners[1], corners[8] - corners[2]};
        edge_reach = larger(max_abs(e1), max_abs(e2));
    }
};

/// Three coordinates of one vector in double.
struct Exact3 {
    double x, y, z;

    [[nodiscard]] HWY_INLINE Point3 rounded() const {
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    }
};
HWY_INLINE Exact3 cross(const Exact3 &a, const Exact3 &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Exact3 exact_difference(const float *a, const float *b) {
    return {a[0] - double(b[0]), a[1] - double(b[1]), a[2] - double(b[2])};
}

/// The triangle's plane as exact_distance() has it.
struct ExactPlane {
    Exact3 e1, e2, n;

    HWY_INLINE explicit ExactPlane(const TriangleSetup &triangle)
        : e1(exact_difference(triangle.corners + 3, triangle.corners)),
          e2(exact_difference(triangle.corners + 6, triangle.corners)),
          n(cross(e1, e2)) {}

    /// n . (a - org)
    [[nodiscard]] HWY_INLINE double offset(const TriangleSetup &triangle, const Point3 &org) const {
        const float *a = triangle.corners;
        return (n.x * (a[0] - double(org.x)) + n.y * (a[1] - double(org.y))) + n.z * (a[2] - double(org.z));
    }
    [[nodiscard]] HWY_INLINE Doubles dot(Doubles x, Doubles y, Doubles z) const {
        return (hn::Set(doubles, n.x) * x + hn::Set(doubles, n.y) * y) + hn::Set(doubles, n.z) * z;
    }
};

/// What the filter says of lane_count rays.
struct FilterResult {
    FloatMask possible; ///< not certainly outside
    FloatMask certain;  ///< certainly inside
};

HWY_INLINE FilterResult judge(Floats det, Floats u, Floats v, Floats margin) {
    const Floats w = (det - u) - v;
    const Floats least = min3(u, v, w), greatest = max3(u, v, w);
    const Floats minus_margin = hn::Neg(margin);
    const FloatMask above = hn::Gt(greatest, margin), below = hn::Lt(least, minus_margin);
    return {hn::Not(hn::And(above, below)), hn::Or(hn::Gt(least, margin), hn::Lt(greatest, minus_margin))};
}

/// How a triangle lies to a whole beam.
enum class BeamVerdict { missed, crossed, covered };

/// A triangle seen from one point.
class TriangleFromPoint {
public:
    /// `dir_reach` is at least the largest coordinate of any direction that will be tested. `off`: how far off lines
    /// may pass the point, times 4 (1 + k).
    HWY_INLINE TriangleFromPoint(const TriangleSetup &triangle, const ExactPlane &plane, const Point3 &org,
                                 float dir_reach, float off)
        : triangle_(triangle), plane_(plane), org_(org), dir_reach_(dir_reach) {
        const float from[3] = {org.x, org.y, org.z};
        const Exact3 s = exact_difference(from, triangle.corners);
        u_ = splat(cross(s, plane.e2).rounded());
        v_ = splat(cross(plane.e1, s).rounded());
        normal_ = plane.n.rounded();
        n_ = splat(normal_);
        const float e = triangle.edge_reach;
        margin_ = splat(dir_reach * e * (from_point_error * (max_abs(s.rounded()) + e) + off) + least_margin);
    }

    [[nodiscard]] HWY_INLINE FilterResult filter(const Points &dir) const {
        return judge(dot(n_, dir), fused_dot(u_, dir), fused_dot(v_, dir), margin_);
    }

    /// What the filter would say of every ray between some directions, one a lane: the numerators are linear in the
    /// direction, so their signs at the corners tell. `corner_reach` is the largest coordinate of a corner.
    [[nodiscard]] HWY_INLINE BeamVerdict judge_beam(const Points &corners, float corner_reach) const {
        const Floats det = fused_dot(n_, corners), u = fused_dot(u_, corners), v = fused_dot(v_, corners);
        const Floats w = (det - u) - v;
        // Four times the margin: a ray's direction is rounded, so it may lie a few eps outside the corners.
        const Floats margin = margin_ * splat(4.0f * corner_reach / dir_reach_) + splat(least_margin);
        const Floats minus_margin = hn::Neg(margin);
        const auto everywhere = [](FloatMask mask) { return bits_of(mask) == all_lanes; };
        const bool some_positive =
            everywhere(hn::Gt(u, margin)) || everywhere(hn::Gt(v, margin)) || everywhere(hn::Gt(w, margin));
        const bool some_negative = everywhere(hn::Lt(u, minus_margin)) || everywhere(hn::Lt(v, minus_margin)) ||
                                   everywhere(hn::Lt(w, minus_margin));
        if (some_positive && some_negative) return BeamVerdict::missed;
        return everywhere(hn::Gt(min3(u, v, w), margin)) || everywhere(hn::Lt(max3(u, v, w), minus_margin))
                   ? BeamVerdict::covered
                   : BeamVerdict::crossed;
    }

    /// Distances as exact_distance() has them where the filter is certain; `lanes` are those that matter.
    [[nodiscard]] HWY_INLINE Floats distances(const Points &dir, uint32_t lanes) {
        if (!has_offset_) make_offset();
        const Floats det = dot(n_, dir);
        const Floats t = offset_ / det;
        if ((bits_of(hn::Lt(hn::Abs(det), least_det_)) & lanes) == 0) return t;
        // Some lanes may graze the triangle: decide by each ray's own direction, go on in double.
        const FloatMask grazing = hn::Lt(hn::Abs(det), splat(least_slope * sum_abs(normal_)) * max_abs(dir));
        const DoubleLanes x = promote(dir.x), y = promote(dir.y), z = promote(dir.z);
        const Doubles offset = hn::Set(doubles, exact_offset_);
        return hn::IfThenElse(
            grazing,
            demote({offset / plane_.dot(x.lower, y.lower, z.lower), offset / plane_.dot(x.upper, y.upper, z.upper)}),
            t);
    }

private:
    HWY_INLINE void make_offset() {
        exact_offset_ = plane_.offset(triangle_, org_);
        offset_ = splat(static_cast<float>(exact_offset_));
        least_det_ = splat(least_slope * sum_abs(normal_) * dir_reach_);
        has_offset_ = true;
    }

    const TriangleSetup &triangle_;
    const ExactPlane &plane_;
    const Point3 &org_;
    float dir_reach_;
    Points u_, v_, n_;
    Point3 normal_;
    Floats margin_;
    bool has_offset_ = false;
    double exact_offset_ = 0.0;
    Floats offset_ = hn::Zero(floats), least_det_ = hn::Zero(floats);
};

/// A triangle for rays that start anywhere.
class TriangleFromAnywhere {
public:
    /// `reach` is at least the largest distance, by coordinate, between an origin and a corner of any triangle.
    HWY_INLINE TriangleFromAnywhere(const TriangleSetup &triangle, float dir_reach, float reach) {
        a_ = splat({triangle.corners[0], triangle.corners[1], triangle.corners[2]});
        e1_ = splat(triangle.e1);
        e2_ = splat(triangle.e2);
        n_ = splat(cross(triangle.e1, triangle.e2));
        const float e = triangle.edge_reach;
        margin_ = splat(from_anywhere_error * dir_reach * e * (reach + 2.0f * e) + least_margin);
        margin_per_q_ = splat(from_anywhere_cross_error * e);
    }

    [[nodiscard]] HWY_INLINE FilterResult filter(const Points &org, const Points &dir) const {
        const Points s = {org.x - a_.x, org.y - a_.y, org.z - a_.z};
        const Points q = {hn::MulSub(dir.y, s.z, dir.z * s.y), hn::MulSub(dir.z, s.x, dir.x * s.z),
                          hn::MulSub(dir.x, s.y, dir.y * s.x)};
        const Floats margin = hn::MulAdd(margin_per_q_, sum_abs(q), margin_);
        return judge(fused_dot(n_, dir), fused_dot(e2_, q), hn::Neg(fused_dot(e1_, q)), margin);
    }

private:
    Points a_, e1_, e2_, n_;
    Floats margin_, margin_per_q_;
};

/// Distances as exact_distance() has them where rays are certainly inside; `lanes` are those that matter.
HWY_INLINE Floats distances_from_anywhere(const TriangleSetup &triangle, const ExactPlane &plane, const Points &org,
                                          const Points &dir, uint32_t lanes) {
    const float *a = triangle.corners;
    const auto offsets = [&](Doubles x, Doubles y, Doubles z) {
        return plane.dot((hn::Set(doubles, double(a[0])) - x), (hn::Set(doubles, double(a[1])) - y),
                         (hn::Set(doubles, double(a[2])) - z));
    };
    const DoubleLanes x = promote(org.x), y = promote(org.y), z = promote(org.z);
    const DoubleLanes offset = {offsets(x.lower, y.lower, z.lower), offsets(x.upper, y.upper, z.upper)};
    const Point3 n = plane.n.rounded();
    const Floats det = dot(splat(n), dir);
    const Floats t = demote(offset) / det;
    const FloatMask grazing = hn::Lt(hn::Abs(det), splat(least_slope * sum_abs(n)) * max_abs(dir));
    if ((bits_of(grazing) & lanes) == 0) return t;
    const DoubleLanes dx = promote(dir.x), dy = promote(dir.y), dz = promote(dir.z);
    return hn::IfThenElse(grazing,
                          demote({offset.lower / plane.dot(dx.lower, dy.lower, dz.lower),
                                  offset.upper / plane.dot(dx.upper, dy.upper, dz.upper)}),
                          t);
}

} // namespace glint::HWY_NAMESPACE
