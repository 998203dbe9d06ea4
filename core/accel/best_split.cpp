// Compares splits by the surface area heuristic.
#include "accel/split.hpp"

namespace glint {

BestSplit::BestSplit(const Box &cell, const CostModel &cost) : cost_(cost) {
    const glm::dvec3 extent = glm::dvec3(cell.hi) - glm::dvec3(cell.lo);
    const double area = cell.half_area();
    // A cell without area (flat in two directions) cannot be judged: every slice counts as met for certain.
    const double inverse_area = area > 0.0 ? 1.0 / area : 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double e1 = extent[(axis + 1) % 3], e2 = extent[(axis + 2) % 3];
        axes_[axis] = {cell.lo[axis], cell.hi[axis], area > 0.0 ? e1 * e2 * inverse_area : 1.0,
                       (e1 + e2) * inverse_area};
    }
}

} // namespace glint
