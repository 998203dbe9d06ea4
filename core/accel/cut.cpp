// Cuts triangles at planes.
#include "accel/reference.hpp"

#include <algorithm>

#include "math/bits.hpp"
#include "math/vec.hpp"

namespace glint {

namespace {

/// The float next to a finite one, away from or towards zero.
float outward(float x) {
    return bit_cast<float>(bit_cast<uint32_t>(x) + 1);
}
float inward(float x) {
    return bit_cast<float>(bit_cast<uint32_t>(x) - 1);
}

/// The largest float <= x and the smallest >= x, for x in the range of floats.
float round_down(double x) {
    const auto nearest = static_cast<float>(x);
    if (nearest <= x) return nearest;
    return nearest > 0.0f ? inward(nearest) : outward(nearest == 0.0f ? -0.0f : nearest);
}
float round_up(double x) {
    return -round_down(-x);
}

/// Grows a box around points on one side of the plane.
struct Side {
    glm::dvec3 lo{std::numeric_limits<double>::infinity()}, hi{-std::numeric_limits<double>::infinity()};

    void extend(const glm::dvec3 &p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    /// What lies inside the bounds.
    [[nodiscard]] Box within(const Box &bounds) const {
        Box box;
        if (lo.x > hi.x) return box;
        box.lo = glm::max(glm::vec3(round_down(lo.x), round_down(lo.y), round_down(lo.z)), bounds.lo);
        box.hi = glm::min(glm::vec3(round_up(hi.x), round_up(hi.y), round_up(hi.z)), bounds.hi);
        return box;
    }
};

} // namespace

Parts cut(const TriangleCorners &triangle, const Box &bounds, int axis, float position) {
    const glm::dvec3 corners[3] = {triangle.a, triangle.b, triangle.c};
    const double plane = position;
    Side lower, upper;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &p = corners[i], &q = corners[i < 2 ? i + 1 : 0];
        const double p_side = component(p, axis) - plane, q_side = component(q, axis) - plane;
        if (p_side <= 0.0) lower.extend(p);
        if (p_side >= 0.0) upper.extend(p);
        if ((p_side < 0.0 && q_side > 0.0) || (p_side > 0.0 && q_side < 0.0)) {
            glm::dvec3 crossing = p + (q - p) * (p_side / (p_side - q_side));
            component(crossing, axis) = plane;
            lower.extend(crossing);
            upper.extend(crossing);
        }
    }
    Parts parts{lower.within(bounds), upper.within(bounds)};
    component(parts.lower.hi, axis) = std::min(component(parts.lower.hi, axis), position);
    component(parts.upper.lo, axis) = std::max(component(parts.upper.lo, axis), position);
    return parts;
}

} // namespace glint
