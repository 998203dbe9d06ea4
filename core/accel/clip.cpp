// Cuts triangles to cells of the tree.
#include "accel/reference.hpp"

#include <cmath>

#include "math/vec.hpp"

namespace glint {

namespace {

/// A triangle cut by the six planes of a box has at most nine corners.
struct Polygon {
    glm::dvec3 corners[9];
    int count = 0;

    void add(const glm::dvec3 &p) { corners[count++] = p; }
};

/// The part of the polygon where sign * (coordinate - plane) >= 0.
Polygon cut(const Polygon &polygon, int axis, double plane, double sign) {
    Polygon inside;
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec3 &p = polygon.corners[i];
        const glm::dvec3 &q = polygon.corners[i + 1 < polygon.count ? i + 1 : 0];
        const double p_side = sign * (component(p, axis) - plane);
        const double q_side = sign * (component(q, axis) - plane);
        if (p_side >= 0.0) inside.add(p);
        if ((p_side > 0.0 && q_side < 0.0) || (p_side < 0.0 && q_side > 0.0)) {
            glm::dvec3 crossing = p + (q - p) * (p_side / (p_side - q_side));
            component(crossing, axis) = plane;
            inside.add(crossing);
        }
    }
    return inside;
}

/// The largest float <= x, and the smallest >= x.
float round_down(double x) {
    const auto f = static_cast<float>(x);
    return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float round_up(double x) {
    const auto f = static_cast<float>(x);
    return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

} // namespace

Box clip_to_cell(const TriangleCorners &triangle, const Box &cell) {
    const Box bounds = triangle.bounds();
    Polygon polygon;
    polygon.add(triangle.a);
    polygon.add(triangle.b);
    polygon.add(triangle.c);
    for (int axis = 0; axis < 3; ++axis) {
        if (component(bounds.lo, axis) < component(cell.lo, axis))
            polygon = cut(polygon, axis, component(cell.lo, axis), 1.0);
        if (component(bounds.hi, axis) > component(cell.hi, axis))
            polygon = cut(polygon, axis, component(cell.hi, axis), -1.0);
    }

    Box clipped;
    if (polygon.count == 0) return clipped;
    for (int axis = 0; axis < 3; ++axis) {
        double lo = component(polygon.corners[0], axis), hi = lo;
        for (int i = 1; i < polygon.count; ++i) {
            lo = std::fmin(lo, component(polygon.corners[i], axis));
            hi = std::fmax(hi, component(polygon.corners[i], axis));
        }
        component(clipped.lo, axis) = std::fmax(round_down(lo), component(cell.lo, axis));
        component(clipped.hi, axis) = std::fmin(round_up(hi), component(cell.hi, axis));
    }
    return clipped;
}

} // namespace glint
