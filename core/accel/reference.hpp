// What the builder moves about: a triangle's part inside one cell.
#pragma once

#include <cstdint>
#include <span>

#include "accel/triangle_data.hpp"
#include "math/box.hpp"

namespace glint {

/// A triangle and bounds of its part inside a cell.
struct Reference {
    Box bounds;
    uint32_t triangle_id;
};

/// The smallest box around all of them.
[[nodiscard]] inline Box hull(std::span<const Reference> references) {
    Box box;
    for (const Reference &reference : references) box.extend(reference.bounds);
    return box;
}

/// Bounds of a triangle's parts on either side of a plane; empty where there is no part.
struct Parts {
    Box lower, upper;
};

/// Cuts the part of a triangle that lies in `bounds` at a plane through them. Computed in double and rounded outwards,
/// so that the boxes never miss any of the triangle; they never reach out of `bounds` or over the plane.
///
/// The whole triangle is cut, then the boxes are: looser than cutting what earlier cuts left, but three edges are all
/// there is to look at (Soupikov et al. 2008, "Fast Parallel Construction of High-Quality Bounding Volume
/// Hierarchies"; Stich et al. 2009, "Spatial Splits in Bounding Volume Hierarchies").
[[nodiscard]] Parts cut(const TriangleCorners &triangle, const Box &bounds, int axis, float position);

} // namespace glint
