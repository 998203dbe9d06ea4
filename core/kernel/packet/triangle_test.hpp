// One triangle against many rays: a float filter, and the distance of intersect.hpp, lane by lane.
#pragma once

#include "kernel/exact.hpp"
#include "kernel/packet/ray_group.hpp"

namespace glint::HWY_NAMESPACE {

/// With s = org - a, n = e1 x e2, a ray meets the triangle's plane at a + U e1 + V e2 where
///     U (n . dir) = dir . (s x e2),   V (n . dir) = dir . (e1 x s),   W = 1 - U - V
/// (Moller & Trumbore 1997). The three numerators, in float, are off by less than this times |dir| |e| (|s| + |e|) in
/// the maximum norm: 98 eps by counting every rounding from the corners on, eps = 2^-24. All above the margin, or all
/// below minus it: certainly inside, and not seen edge on. One above and one below: certainly outside. All else is for
/// exact_distance().
inline constexpr float filter_error = 0x1p-17f;
/// Added to the margin: covers what is lost where products fall below the smallest normal float.
inline constexpr float least_margin = 0x1p-120f;

/// What all tests of a triangle share.
struct TriangleSetup {
    float corners[9];
    Point3 e1, e2, n;
    float edge_reach; ///< largest coordinate of e1 and e2
    uint32_t id;

    HWY_INLINE TriangleSetup(const uint32_t *leaf_words, uint32_t count, uint32_t i) {
        for (uint32_t row = 0; row < 9; ++row) __builtin_memcpy(&corners[row], &leaf_words[row * count + i], 4);
        id = leaf_words[9 * count + i];
        e1 = {corners[3] - corners[0], corners[4] - corners[1], corners[5] - corners[2]};
        e2 = {corners[6] - corners[0], corners[7] - corners[1], corners[8] - corners[2]};
        n = cross(e1, e2);
        edge_reach = larger(max_abs(e1), max_abs(e2));
    }
};

/// The triangle's plane as intersect() computes distances to it.
struct ExactPlane {
    double n_x, n_y, n_z;

    ExactPlane() = default;
    HWY_INLINE explicit ExactPlane(const TriangleSetup &triangle) {
        const float *c = triangle.corners;
        const double ax = c[0], ay = c[1], az = c[2];
        const double e1x = c[3] - ax, e1y = c[4] - ay, e1z = c[5] - az;
        const double e2x = c[6] - ax, e2y = c[7] - ay, e2z = c[8] - az;
        n_x = e1y * e2z - e1z * e2y;
        n_y = e1z * e2x - e1x * e2z;
        n_z = e1x * e2y - e1y * e2x;
    }
    [[nodiscard]] HWY_INLINE Point3 normal() const {
        return {static_cast<float>(n_x), static_cast<float>(n_y), static_cast<float>(n_z)};
    }
    /// n . (a - org)
    [[nodiscard]] HWY_INLINE double offset(const TriangleSetup &triangle, const Point3 &org) const {
        const float *a = triangle.corners;
        return (n_x * (a[0] - double(org.x)) + n_y * (a[1] - double(org.y))) + n_z * (a[2] - double(org.z));
    }
    [[nodiscard]] HWY_INLINE Doubles dot(Doubles x, Doubles y, Doubles z) const {
        return (hn::Set(doubles, n_x) * x + hn::Set(doubles, n_y) * y) + hn::Set(doubles, n_z) * z;
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

/// A triangle seen from one point.
class TriangleFromPoint {
public:
    /// `dir_reach` is at least the largest coordinate of any direction that will be tested.
    HWY_INLINE TriangleFromPoint(const TriangleSetup &triangle, const Point3 &org, float dir_reach)
        : triangle_(triangle), org_(org), dir_reach_(dir_reach) {
        const Point3 s = {org.x - triangle.corners[0], org.y - triangle.corners[1], org.z - triangle.corners[2]};
        u_ = splat(cross(s, triangle.e2));
        v_ = splat(cross(triangle.e1, s));
        n_ = splat(triangle.n);
        const float e = triangle.edge_reach;
        margin_ = splat(filter_error * dir_reach * e * (max_abs(s) + e) + least_margin);
    }

    [[nodiscard]] HWY_INLINE FilterResult filter(const Points &dir) const {
        return judge(dot(n_, dir), dot(u_, dir), dot(v_, dir), margin_);
    }

    /// Distances as intersect() has them where the filter is certain; `lanes` are those that matter.
    [[nodiscard]] HWY_INLINE Floats distances(const Points &dir, uint32_t lanes) {
        if (!has_plane_) make_plane();
        const Floats det = dot(plane_n_, dir);
        const Floats t = offset_ / det;
        if ((bits_of(hn::Lt(hn::Abs(det), least_det_)) & lanes) == 0) return t;
        // Some lanes may graze the triangle: decide by each ray's own direction, go on in double.
        const FloatMask grazing = hn::Lt(hn::Abs(det), splat(least_slope * sum_abs(normal_)) * max_abs(dir));
        const DoubleLanes x = promote(dir.x), y = promote(dir.y), z = promote(dir.z);
        const Doubles offset = hn::Set(doubles, exact_offset_);
        return hn::IfThenElse(grazing, demote({offset / exact_.dot(x.lower, y.lower, z.lower),
                                               offset / exact_.dot(x.upper, y.upper, z.upper)}), t);
    }

private:
    HWY_INLINE void make_plane() {
        exact_ = ExactPlane(triangle_);
        normal_ = exact_.normal();
        exact_offset_ = exact_.offset(triangle_, org_);
        plane_n_ = splat(normal_);
        offset_ = splat(static_cast<float>(exact_offset_));
        least_det_ = splat(least_slope * sum_abs(normal_) * dir_reach_);
        has_plane_ = true;
    }

    const TriangleSetup &triangle_;
    const Point3 &org_;
    float dir_reach_;
    Points u_, v_, n_;
    Floats margin_;
    bool has_plane_ = false;
    ExactPlane exact_{};
    double exact_offset_ = 0.0;
    Point3 normal_{};
    Points plane_n_;
    Floats offset_, least_det_;
};

/// A triangle for rays that start anywhere.
class TriangleFromAnywhere {
public:
    /// `reach` is at least the largest distance, by coordinate, between an origin and a corner of any triangle.
    HWY_INLINE TriangleFromAnywhere(const TriangleSetup &triangle, float dir_reach, float reach)
        : triangle_(triangle), dir_reach_(dir_reach) {
        a_ = splat({triangle.corners[0], triangle.corners[1], triangle.corners[2]});
        e1_ = splat(triangle.e1);
        e2_ = splat(triangle.e2);
        n_ = splat(triangle.n);
        margin_ = splat(filter_error * dir_reach * triangle.edge_reach * (reach + triangle.edge_reach) + least_margin);
    }

    [[nodiscard]] HWY_INLINE FilterResult filter(const Points &org, const Points &dir) const {
        const Points s = {org.x - a_.x, org.y - a_.y, org.z - a_.z};
        const Points q = {dir.y * s.z - dir.z * s.y, dir.z * s.x - dir.x * s.z, dir.x * s.y - dir.y * s.x};
        return judge(dot(n_, dir), dot(e2_, q), hn::Neg(dot(e1_, q)), margin_);
    }

    /// Distances as intersect() has them where the filter is certain; `lanes` are those that matter.
    [[nodiscard]] HWY_INLINE Floats distances(const Points &org, const Points &dir, uint32_t lanes) const {
        const ExactPlane plane(triangle_);
        const float *a = triangle_.corners;
        const auto offsets = [&](Doubles x, Doubles y, Doubles z) {
            return plane.dot((hn::Set(doubles, double(a[0])) - x), (hn::Set(doubles, double(a[1])) - y),
                             (hn::Set(doubles, double(a[2])) - z));
        };
        const DoubleLanes x = promote(org.x), y = promote(org.y), z = promote(org.z);
        const DoubleLanes offset = {offsets(x.lower, y.lower, z.lower), offsets(x.upper, y.upper, z.upper)};
        const Point3 n = plane.normal();
        const Floats det = dot(splat(n), dir);
        const Floats t = demote(offset) / det;
        const FloatMask grazing = hn::Lt(hn::Abs(det), splat(least_slope * sum_abs(n)) * max_abs(dir));
        if ((bits_of(grazing) & lanes) == 0) return t;
        const DoubleLanes dx = promote(dir.x), dy = promote(dir.y), dz = promote(dir.z);
        return hn::IfThenElse(grazing, demote({offset.lower / plane.dot(dx.lower, dy.lower, dz.lower),
                                               offset.upper / plane.dot(dx.upper, dy.upper, dz.upper)}), t);
    }

private:
    const TriangleSetup &triangle_;
    float dir_reach_;
    Points a_, e1_, e2_, n_;
    Floats margin_;
};

} // namespace glint::HWY_NAMESPACE
