// What the builder moves about: a triangle's part inside one cell.
#pragma once

#include <cstdint>
#include <vector>

#include "accel/triangle_data.hpp"
#include "math/box.hpp"

namespace glint {

/// A triangle and the bounds of its part inside a cell.
struct Reference {
    Box bounds;
    uint32_t triangle_id;
};

/// Bounds of the part of a triangle inside a closed cell; empty when no part is. Computed in double and rounded
/// outwards, so that the box never misses any of that part; it never reaches out of the cell.
/// (Sutherland & Hodgman 1974, "Reentrant polygon clipping".)
[[nodiscard]] Box clip_to_cell(const TriangleCorners &triangle, const Box &cell);

} // namespace glint
