// Where a vector of rays meets a quadric. The arithmetic is that of kernel/quadric.hpp, operation by operation; read
// that first.
#pragma once

#include "accel/quadric_tree.hpp"
#include "kernel/packet/lanes.hpp"

namespace glint::HWY_NAMESPACE {

/// Three coordinates of as many points or vectors as doubles fit a vector.
struct DoublePoints {
    Doubles x, y, z;
};
HWY_INLINE Doubles dot(const DoublePoints &a, const DoublePoints &b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
HWY_INLINE Doubles splat_double(double value) {
    return hn::Set(doubles, value);
}

/// Vectors of points as doubles: the lower lanes, the upper lanes.
struct DoublePointLanes {
    DoublePoints lower, upper;
};
HWY_INLINE DoublePointLanes promote(const Points &p) {
    const DoubleLanes x = promote(p.x), y = promote(p.y), z = promote(p.z);
    return {{x.lower, y.lower, z.lower}, {x.upper, y.upper, z.upper}};
}

HWY_INLINE DoublePoints quadric_slope(const PlacedQuadric &q, const DoublePoints &v) {
    const Doubles a = splat_double(q.a), b = splat_double(q.b), c = splat_double(q.c), d = splat_double(q.d),
                  e = splat_double(q.e), f = splat_double(q.f);
    return {(a * v.x + d * v.y) + f * v.z, (d * v.x + b * v.y) + e * v.z, (f * v.x + e * v.y) + c * v.z};
}

/// The gradient, halved.
HWY_INLINE DoublePoints half_gradient(const PlacedQuadric &q, const DoublePoints &at) {
    const DoublePoints slope = quadric_slope(q, at);
    return {slope.x + splat_double(q.g), slope.y + splat_double(q.h), slope.z + splat_double(q.j)};
}

/// t where the rays' points there lie within the bounds, else -1.
HWY_INLINE Doubles if_within(const Box &box, const DoublePoints &org, const DoublePoints &dir, Doubles t) {
    const auto is_in = [](Doubles p, float lo, float hi) {
        return hn::And(hn::Ge(p, splat_double(lo)), hn::Le(p, splat_double(hi)));
    };
    const auto x = is_in(org.x + t * dir.x, box.lo.x, box.hi.x);
    const auto y = is_in(org.y + t * dir.y, box.lo.y, box.hi.y);
    const auto z = is_in(org.z + t * dir.z, box.lo.z, box.hi.z);
    return hn::IfThenElse(hn::And(hn::And(x, y), z), t, splat_double(-1.0));
}

/// Both roots; not above 0 where there are none.
struct QuadricRoots {
    Doubles near, far;
};
HWY_INLINE QuadricRoots quadric_roots(const PlacedQuadric &q, const DoublePoints &org, const DoublePoints &dir) {
    const DoublePoints along = quadric_slope(q, dir), gradient = half_gradient(q, org);
    const Doubles a = dot(dir, along), b = dot(dir, gradient);
    const DoublePoints twice = {gradient.x + splat_double(q.g), gradient.y + splat_double(q.h),
                                gradient.z + splat_double(q.j)};
    const Doubles c = dot(org, twice) + splat_double(q.k);
    const Doubles discriminant = b * b - a * c;
    const Doubles zero = splat_double(0.0), none = splat_double(-1.0);
    const auto is_met = hn::Ge(discriminant, zero);
    const Doubles root = hn::Sqrt(hn::IfThenElse(is_met, discriminant, zero));
    const Doubles away_from_zero = hn::IfThenElse(hn::Lt(b, zero), root - b, hn::Neg(b + root));
    const Doubles one = away_from_zero / a, other = c / away_from_zero;
    const auto in_order = hn::Lt(one, other);
    const Doubles near = hn::IfThenElse(in_order, one, other), far = hn::IfThenElse(in_order, other, one);
    return {hn::IfThenElse(is_met, if_within(q.bounds, org, dir, near), none),
            hn::IfThenElse(is_met, if_within(q.bounds, org, dir, far), none)};
}

/// quadric_distance() in every lane; not above 0 where the ray does not meet the quadric.
HWY_INLINE Floats quadric_distances(const PlacedQuadric &q, const DoublePointLanes &org, const DoublePointLanes &dir) {
    const QuadricRoots lower = quadric_roots(q, org.lower, dir.lower), upper = quadric_roots(q, org.upper, dir.upper);
    const Floats near = demote({lower.near, upper.near}), far = demote({lower.far, upper.far});
    return hn::IfThenElse(hn::Gt(near, hn::Zero(floats)), near, far);
}

/// quadric_normal() in every lane.
HWY_INLINE Points quadric_normals(const PlacedQuadric &q, const Points &point, const Points &otherwise) {
    const DoublePointLanes at = promote(point);
    const auto normals = [&](const DoublePoints &p, Doubles &length) {
        const DoublePoints n = half_gradient(q, p);
        length = hn::Sqrt(dot(n, n));
        const Doubles inverse = splat_double(1.0) / length;
        return DoublePoints{n.x * inverse, n.y * inverse, n.z * inverse};
    };
    DoubleLanes length{splat_double(0.0), splat_double(0.0)};
    const DoublePoints lower = normals(at.lower, length.lower), upper = normals(at.upper, length.upper);
    // A length that only vanishes as a float is a length: ask in double.
    const auto as_flag = [](Doubles l) {
        return hn::IfThenElse(hn::Lt(splat_double(0.0), l), splat_double(1.0), splat_double(0.0));
    };
    const FloatMask has_length = hn::Gt(demote({as_flag(length.lower), as_flag(length.upper)}), hn::Zero(floats));
    return either(has_length, {demote({lower.x, upper.x}), demote({lower.y, upper.y}), demote({lower.z, upper.z})},
                  otherwise);
}

} // namespace glint::HWY_NAMESPACE
