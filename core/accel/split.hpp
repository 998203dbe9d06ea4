// Where to cut a cell in two.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>

#include "accel/cell.hpp"
#include "math/vec.hpp"

namespace glint {

/// A plane and what the surface area heuristic expects of it. Triangles that lie in the plane go to one side, those
/// that only touch it stay on their own side, others go to both.
struct Split {
    float cost = std::numeric_limits<float>::infinity(); ///< infinite = there is no plane to split at
    float position = 0.0f;                               ///< inside the cell, or a face of it: see Slices
    int axis = 0;
    bool planar_to_lower = true;  ///< side of triangles that lie in the plane
    int32_t lower = 0, upper = 0; ///< expected number of triangles on either side

    [[nodiscard]] bool exists() const { return cost < std::numeric_limits<float>::infinity(); }

    [[nodiscard]] bool cuts_off_empty_space() const { return exists() && (lower == 0 || upper == 0); }

    /// The two cells, given how many references they really got.
    [[nodiscard]] std::pair<Cell, Cell> cells(const Cell &cell, size_t lower_count, size_t upper_count) const;
};

/// How a cell's surface is shared by slices across an axis. A plane in one of the cell's own faces may only set apart
/// the triangles that lie in it, in a flat cell.
struct Slices {
    float lo, hi;
    float cap, girth; ///< a slice has cap + girth * thickness of the cell's surface

    [[nodiscard]] bool flat() const { return !(lo < hi); }
    [[nodiscard]] float lower_share(float plane) const { return cap + (plane - lo) * girth; }
    [[nodiscard]] float upper_share(float plane) const { return cap + (hi - plane) * girth; }
};

class CellSurface {
public:
    explicit CellSurface(const Box &cell);
    [[nodiscard]] Slices across(int axis) const;

private:
    Box cell_;
    glm::dvec3 extent_;
    double inverse_area_;
};

} // namespace glint
