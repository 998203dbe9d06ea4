// Where to cut a cell in two.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "accel/cell.hpp"
#include "accel/cost_model.hpp"
#include "accel/reference.hpp"
#include "math/vec.hpp"

namespace glint {

/// A plane and what the surface area heuristic expects of it. Triangles that lie in the plane go to one side, those
/// that only touch it stay on their own side, others go to both.
struct Split {
    float cost = std::numeric_limits<float>::infinity(); ///< infinite = there is no plane to split at
    float position = 0.0f;                               ///< inside the cell, or a face of it: see Slices
    int axis = 0;
    bool planar_to_lower = true;   ///< side of triangles that lie in the plane
    uint32_t lower = 0, upper = 0; ///< expected number of triangles on either side

    [[nodiscard]] bool exists() const { return cost < std::numeric_limits<float>::infinity(); }

    /// The two cells, given how many references they really got.
    [[nodiscard]] std::pair<Cell, Cell> cells(const Cell &cell, size_t lower_count, size_t upper_count) const;
};

/// How a cell's surface is shared by slices across an axis. A plane in one of the cell's own faces may only set apart
/// the triangles that lie in it, in a flat cell.
struct Slices {
    float lo, hi;
    float cap, girth; ///< a slice has cap + girth * thickness of the cell's surface

    Slices(const Box &cell, int axis);
    [[nodiscard]] bool flat() const { return !(lo < hi); }
    [[nodiscard]] float lower_share(float plane) const { return cap + (plane - lo) * girth; }
    [[nodiscard]] float upper_share(float plane) const { return cap + (hi - plane) * girth; }
};

/// The cheapest split, or none where a leaf is cheaper or the cell has come to a limit.
[[nodiscard]] Split choose_split(std::span<const Reference> references, const Cell &cell, const CostModel &cost);

/// At most this many references are searched exactly.
inline constexpr size_t exact_limit = 24;

/// The best of all planes through a triangle's boundary, for up to exact_limit references.
[[nodiscard]] Split find_exact_split(std::span<const Reference> references, const Box &cell, const CostModel &cost);

/// The best of the outermost boundaries in each of evenly spaced bins, and of the cell's faces; a sample of many
/// references stands for all.
[[nodiscard]] Split find_binned_split(std::span<const Reference> references, const Box &cell, const CostModel &cost);

/// The best plane that has all references on one side and nothing on the other.
[[nodiscard]] Split find_empty_space(std::span<const Reference> references, const Box &cell, const CostModel &cost);

} // namespace glint
