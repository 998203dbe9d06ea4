// Where to cut a cell in two.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "accel/reference.hpp"

namespace glint {

/// A plane and what the surface area heuristic expects of it.
struct Split {
    double cost = std::numeric_limits<double>::infinity(); ///< infinite = there is no plane to split at
    float position = 0.0f;                                 ///< strictly inside the cell
    int axis = 0;
    bool planar_to_lower = true; ///< side of triangles that lie in the plane

    /// Triangles that lie in the plane go to one side, those that only touch it stay on their own side, others to both.
    [[nodiscard]] bool goes_lower(const Box &bounds) const {
        return bounds.lo[axis] < position || (planar_to_lower && bounds.hi[axis] == position);
    }
    [[nodiscard]] bool goes_upper(const Box &bounds) const {
        return bounds.hi[axis] > position || (!planar_to_lower && bounds.lo[axis] == position);
    }
    [[nodiscard]] Box lower_cell(Box cell) const { return cell.hi[axis] = position, cell; }
    [[nodiscard]] Box upper_cell(Box cell) const { return cell.lo[axis] = position, cell; }
};

/// Keeps the cheaper of the splits it is shown; the first one of equals.
class BestSplit {
public:
    explicit BestSplit(const Box &cell);

    /// Offers a plane with the number of triangles below, in and above it. Planes outside the open cell are ignored.
    void offer(int axis, float position, uint64_t below, uint64_t planar, uint64_t above);

    [[nodiscard]] const Split &best() const { return best_; }

private:
    Box cell_;
    double inverse_area_;
    Split best_;
};

/// The best of evenly spaced planes and of the planes that cut off empty space; O(n).
[[nodiscard]] Split find_binned_split(std::span<const Reference> references, const Box &cell);

/// The best of all planes through a triangle's boundary: exact, O(n log n).
[[nodiscard]] Split find_swept_split(std::span<const Reference> references, const Box &cell);

} // namespace glint
