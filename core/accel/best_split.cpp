// Compares splits by the surface area heuristic.
#include "accel/cost_model.hpp"
#include "accel/split.hpp"

namespace glint {

BestSplit::BestSplit(const Box &cell) : cell_(cell) {
    const double area = cell.half_area();
    // A cell without area (all triangles on one line's extent) cannot be judged: every split looks free of charge.
    inverse_area_ = area > 0.0 ? 1.0 / area : 0.0;
}

void BestSplit::offer(int axis, float position, uint64_t below, uint64_t planar, uint64_t above) {
    if (!(position > cell_.lo[axis] && position < cell_.hi[axis])) return;
    Split split;
    split.axis = axis;
    split.position = position;
    const double lower = split.lower_cell(cell_).half_area() * inverse_area_;
    const double upper = split.upper_cell(cell_).half_area() * inverse_area_;
    split.cost = CostModel::split(lower, below + planar, upper, above);
    if (planar > 0) {
        const double cost_upper = CostModel::split(lower, below, upper, above + planar);
        if (cost_upper < split.cost) {
            split.cost = cost_upper;
            split.planar_to_lower = false;
        }
    }
    if (split.cost < best_.cost) best_ = split;
}

} // namespace glint
