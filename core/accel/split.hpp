// Where to cut a cell in two.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "accel/cost_model.hpp"
#include "accel/reference.hpp"
#include "math/vec.hpp"

namespace glint {

/// A plane and what the surface area heuristic expects of it.
struct Split {
    double cost = std::numeric_limits<double>::infinity(); ///< infinite = there is no plane to split at
    float position = 0.0f;                                 ///< inside the cell, or a face of it: see BestSplit
    int axis = 0;
    bool planar_to_lower = true; ///< side of triangles that lie in the plane

    /// Triangles that lie in the plane go to one side, those that only touch it stay on their own side, others to both.
    [[nodiscard]] bool goes_lower(const Box &bounds) const {
        return component(bounds.lo, axis) < position || (planar_to_lower && component(bounds.hi, axis) == position);
    }
    [[nodiscard]] bool goes_upper(const Box &bounds) const {
        return component(bounds.hi, axis) > position || (!planar_to_lower && component(bounds.lo, axis) == position);
    }
    [[nodiscard]] Box lower_cell(Box cell) const { return component(cell.hi, axis) = position, cell; }
    [[nodiscard]] Box upper_cell(Box cell) const { return component(cell.lo, axis) = position, cell; }
};

/// Keeps the cheaper of the splits it is shown; the first one of equals.
class BestSplit {
public:
    BestSplit(const Box &cell, const CostModel &cost);

    /// Offers a plane with the number of triangles below, in and above it. A plane in one of the cell's own faces may
    /// only set apart the triangles that lie in it, in a flat cell; planes outside are ignored.
    void offer(int axis, float position, uint64_t below, uint64_t planar, uint64_t above) {
        const Axis &a = axes_[axis];
        if (position < a.lo || position > a.hi || a.lo == a.hi) return;
        const bool lowest = position == a.lo, highest = position == a.hi;
        if ((lowest || highest) && planar == 0) return;
        const double lower = a.cap + (double(position) - a.lo) * a.girth;
        const double upper = a.cap + (double(a.hi) - position) * a.girth;
        if (!highest) accept(axis, position, cost_.split(lower, below + planar, upper, above), true);
        if (!lowest && planar > 0) {
            accept(axis, position, cost_.split(lower, below, upper, above + planar), false);
        }
    }

    [[nodiscard]] const Split &best() const { return best_; }

private:
    /// A slice of the cell across an axis has a surface of cap + girth * thickness, as a share of the cell's.
    struct Axis {
        float lo, hi;
        double cap, girth;
    };

    void accept(int axis, float position, double cost, bool planar_to_lower) {
        if (cost < best_.cost) best_ = {cost, position, axis, planar_to_lower};
    }

    CostModel cost_;
    Axis axes_[3];
    Split best_;
};

/// The best of evenly spaced planes, of the planes that cut off empty space and of the cell's faces; O(n).
[[nodiscard]] Split find_binned_split(std::span<const Reference> references, const Box &cell, const CostModel &cost);

/// The best of all planes through a triangle's boundary: exact, O(n log n).
[[nodiscard]] Split find_swept_split(std::span<const Reference> references, const Box &cell, const CostModel &cost);

} // namespace glint
