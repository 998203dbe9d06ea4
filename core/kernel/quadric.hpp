// Where a ray meets a quadric, and the quadrics that it may meet.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/vec3.hpp>

#include "accel/quadric_tree.hpp"
#include "kernel/walk_boxes.hpp"

namespace glint {

/// A QuadricTree as the kernels see it.
struct QuadricView {
    const PlacedQuadric *all;
    const BoxNode *nodes; ///< over those behind the unbounded ones, if there are any
    uint32_t count, unbounded_count;
    const uint32_t *places; ///< in `all`, by number of quadric in the scene

    [[nodiscard]] const PlacedQuadric &by_number(uint32_t number) const { return all[places[number]]; }
};

/// The coefficients' matrix times a vector: half the gradient's change along it.
inline glm::dvec3 quadric_slope(const PlacedQuadric &q, const glm::dvec3 &v) {
    return {(q.a * v.x + q.d * v.y) + q.f * v.z, (q.d * v.x + q.b * v.y) + q.e * v.z,
            (q.f * v.x + q.e * v.y) + q.c * v.z};
}

/// Whether the box holds the ray's point at t.
inline bool holds_point(const Box &box, const glm::dvec3 &org, const glm::dvec3 &dir, double t) {
    const glm::dvec3 p(org.x + t * dir.x, org.y + t * dir.y, org.z + t * dir.z);
    return p.x >= double(box.lo.x) && p.x <= double(box.hi.x) && p.y >= double(box.lo.y) && p.y <= double(box.hi.y) &&
           p.z >= double(box.lo.z) && p.z <= double(box.hi.z);
}

/// Least distance t > t_least >= 0 at which the ray meets the quadric within its bounds, NaN where it does not.
///
/// Along the ray the quadric is A t^2 + 2 B t + C. Of the two forms of the roots, q / A and C / q with q = -(B +-
/// sqrt(B^2
/// - A C)), neither subtracts numbers of about the same size (Press et al., "Numerical Recipes", section 5.6), and
/// where A is 0 the second is the only root. In double, since a float's 24 bits are gone as soon as a sphere is seen
/// from a hundred radii away.
inline float quadric_distance(const PlacedQuadric &q, const PreparedRay &ray, float t_least = 0.0f) {
    const glm::dvec3 org(ray.org), dir(ray.dir);
    const glm::dvec3 along = quadric_slope(q, dir), at = quadric_slope(q, org);
    const glm::dvec3 half_gradient(at.x + q.g, at.y + q.h, at.z + q.j);
    const double a = (dir.x * along.x + dir.y * along.y) + dir.z * along.z;
    const double b = (dir.x * half_gradient.x + dir.y * half_gradient.y) + dir.z * half_gradient.z;
    const double c =
        ((org.x * (half_gradient.x + q.g) + org.y * (half_gradient.y + q.h)) + org.z * (half_gradient.z + q.j)) + q.k;
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0.0)) return std::numeric_limits<float>::quiet_NaN();
    const double root = std::sqrt(discriminant);
    const double away_from_zero = b < 0.0 ? root - b : -(b + root);
    const double one = away_from_zero / a, other = c / away_from_zero;
    // Written so that a root that is not there (NaN) comes first, and is passed over.
    const bool in_order = one < other;
    const double near = in_order ? one : other, far = in_order ? other : one;
    const auto t_near = static_cast<float>(near), t_far = static_cast<float>(far);
    if (t_near > t_least && holds_point(q.bounds, org, dir, near)) return t_near;
    if (t_far > t_least && holds_point(q.bounds, org, dir, far)) return t_far;
    return std::numeric_limits<float>::quiet_NaN();
}

/// Unit normal at a point of the quadric: the gradient, rounded once. At a cone's tip, where there is none,
/// `otherwise`.
inline glm::vec3 quadric_normal(const PlacedQuadric &q, const glm::vec3 &point, const glm::vec3 &otherwise) {
    const glm::dvec3 at = quadric_slope(q, glm::dvec3(point));
    const glm::dvec3 n(at.x + q.g, at.y + q.h, at.z + q.j);
    const double length = std::sqrt((n.x * n.x + n.y * n.y) + n.z * n.z);
    if (!(length > 0.0)) return otherwise;
    const double inverse = 1.0 / length;
    return {static_cast<float>(n.x * inverse), static_cast<float>(n.y * inverse), static_cast<float>(n.z * inverse)};
}

/// Calls visit(quadric) for every quadric that the ray may meet before search_end(t_max), until a call returns true.
/// `visit` may lower t_max.
template <typename Visit>
void walk_quadrics(const QuadricView &quadrics, const PreparedRay &ray, const float &t_max, Visit &&visit) {
    for (uint32_t i = 0; i < quadrics.unbounded_count; ++i) {
        if (visit(quadrics.all[i])) return;
    }
    if (quadrics.count == quadrics.unbounded_count) return;
    walk_boxes(quadrics.nodes, ray, t_max,
               [&](uint32_t i) { return visit(quadrics.all[quadrics.unbounded_count + i]); });
}

} // namespace glint
