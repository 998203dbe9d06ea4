// One triangle against many rays: the float filter and the double distance of intersect.hpp, lane by lane.
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
    Point3 e1, e2;
    double n_x, n_y, n_z; ///< e1 x e2, as the definition computes it
    float edge_reach;     ///< largest coordinate of e1 and e2
    uint32_t id;

    HWY_INLINE TriangleSetup(const uint32_t *leaf_words, uint32_t count, uint32_t i) {
        for (uint32_t row = 0; row < 9; ++row) __builtin_memcpy(&corners[row], &leaf_words[row * count + i], 4);
        id = leaf_words[9 * count + i];
        const double ax = corners[0], ay = corners[1], az = corners[2];
        const double e1x = corners[3] - ax, e1y = corners[4] - ay, e1z = corners[5] - az;
        const double e2x = corners[6] - ax, e2y = corners[7] - ay, e2z = corners[8] - az;
        n_x = e1y * e2z - e1z * e2y;
        n_y = e1z * e2x - e1x * e2z;
        n_z = e1x * e2y - e1y * e2x;
        e1 = {static_cast<float>(e1x), static_cast<float>(e1y), static_cast<float>(e1z)};
        e2 = {static_cast<float>(e2x), static_cast<float>(e2y), static_cast<float>(e2z)};
        edge_reach = larger(larger(larger(magnitude(e1.x), magnitude(e1.y)), magnitude(e1.z)),
                            larger(larger(magnitude(e2.x), magnitude(e2.y)), magnitude(e2.z)));
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
        : triangle_(triangle) {
        const float *a = triangle.corners;
        const Point3 s = {org.x - a[0], org.y - a[1], org.z - a[2]}, &e1 = triangle.e1, &e2 = triangle.e2;
        u_ = splat({s.y * e2.z - s.z * e2.y, s.z * e2.x - s.x * e2.z, s.x * e2.y - s.y * e2.x});
        v_ = splat({e1.y * s.z - e1.z * s.y, e1.z * s.x - e1.x * s.z, e1.x * s.y - e1.y * s.x});
        n_ = splat({static_cast<float>(triangle.n_x), static_cast<float>(triangle.n_y),
                    static_cast<float>(triangle.n_z)});
        const float distance = larger(larger(magnitude(s.x), magnitude(s.y)), magnitude(s.z));
        const float e = triangle.edge_reach;
        margin_ = splat(filter_error * dir_reach * e * (distance + e) + least_margin);
        numerator_ = (triangle.n_x * (a[0] - double(org.x)) + triangle.n_y * (a[1] - double(org.y))) +
                     triangle.n_z * (a[2] - double(org.z));
    }

    [[nodiscard]] HWY_INLINE FilterResult filter(const Points &dir) const {
        return judge(dot(n_, dir), dot(u_, dir), dot(v_, dir), margin_);
    }

    /// Distance to the triangle's plane.
    [[nodiscard]] HWY_INLINE Floats distance(const Points &dir) const {
        const Doubles n_x = hn::Set(doubles, triangle_.n_x), n_y = hn::Set(doubles, triangle_.n_y),
                      n_z = hn::Set(doubles, triangle_.n_z), numerator = hn::Set(doubles, numerator_);
        const DoubleLanes x = promote(dir.x), y = promote(dir.y), z = promote(dir.z);
        return demote({numerator / ((n_x * x.lower + n_y * y.lower) + n_z * z.lower),
                       numerator / ((n_x * x.upper + n_y * y.upper) + n_z * z.upper)});
    }

private:
    const TriangleSetup &triangle_;
    Points u_, v_, n_;
    Floats margin_;
    double numerator_;
};

/// A triangle for rays that start anywhere.
class TriangleFromAnywhere {
public:
    /// `reach` is at least the largest distance, by coordinate, between an origin and a corner of any triangle.
    HWY_INLINE TriangleFromAnywhere(const TriangleSetup &triangle, float dir_reach, float reach) : triangle_(triangle) {
        a_ = splat({triangle.corners[0], triangle.corners[1], triangle.corners[2]});
        e1_ = splat(triangle.e1);
        e2_ = splat(triangle.e2);
        n_ = splat({static_cast<float>(triangle.n_x), static_cast<float>(triangle.n_y),
                    static_cast<float>(triangle.n_z)});
        margin_ = splat(filter_error * dir_reach * triangle.edge_reach * (reach + triangle.edge_reach) + least_margin);
    }

    [[nodiscard]] HWY_INLINE FilterResult filter(const Points &org, const Points &dir) const {
        const Points s = {org.x - a_.x, org.y - a_.y, org.z - a_.z};
        const Points q = {dir.y * s.z - dir.z * s.y, dir.z * s.x - dir.x * s.z, dir.x * s.y - dir.y * s.x};
        return judge(dot(n_, dir), dot(e2_, q), hn::Neg(dot(e1_, q)), margin_);
    }

    [[nodiscard]] HWY_INLINE Floats distance(const Points &org, const Points &dir) const {
        const DoubleLanes ox = promote(org.x), oy = promote(org.y), oz = promote(org.z);
        const DoubleLanes dx = promote(dir.x), dy = promote(dir.y), dz = promote(dir.z);
        return demote({distance(ox.lower, oy.lower, oz.lower, dx.lower, dy.lower, dz.lower),
                       distance(ox.upper, oy.upper, oz.upper, dx.upper, dy.upper, dz.upper)});
    }

private:
    [[nodiscard]] HWY_INLINE Doubles distance(Doubles ox, Doubles oy, Doubles oz, Doubles dx, Doubles dy,
                                              Doubles dz) const {
        const Doubles n_x = hn::Set(doubles, triangle_.n_x), n_y = hn::Set(doubles, triangle_.n_y),
                      n_z = hn::Set(doubles, triangle_.n_z);
        const Doubles x = hn::Set(doubles, double(triangle_.corners[0])) - ox,
                      y = hn::Set(doubles, double(triangle_.corners[1])) - oy,
                      z = hn::Set(doubles, double(triangle_.corners[2])) - oz;
        return ((n_x * x + n_y * y) + n_z * z) / ((n_x * dx + n_y * dy) + n_z * dz);
    }

    const TriangleSetup &triangle_;
    Points a_, e1_, e2_, n_;
    Floats margin_;
};

} // namespace glint::HWY_NAMESPACE
