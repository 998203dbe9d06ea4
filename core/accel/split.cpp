// What follows from a split.
#include "accel/split.hpp"

namespace glint {

CellSurface::CellSurface(const Box &cell) : cell_(cell), extent_(glm::dvec3(cell.hi) - glm::dvec3(cell.lo)) {
    const double area = cell.half_area();
    inverse_area_ = area > 0.0 ? 1.0 / area : 0.0;
}

Slices CellSurface::across(int axis) const {
    const double e1 = component(extent_, axis < 2 ? axis + 1 : 0), e2 = component(extent_, axis > 0 ? axis - 1 : 2);
    // A cell without area (flat in two directions) cannot be judged: every slice counts as met for certain.
    return {component(cell_.lo, axis), component(cell_.hi, axis),
            inverse_area_ > 0.0 ? static_cast<float>(e1 * e2 * inverse_area_) : 1.0f,
            static_cast<float>((e1 + e2) * inverse_area_)};
}

std::pair<Cell, Cell> Split::cells(const Cell &cell, size_t lower_count, size_t upper_count) const {
    Cell low = cell, high = cell;
    component(low.box.hi, axis) = component(high.box.lo, axis) = position;
    low.levels_left = high.levels_left = cell.levels_left - 1;
    const double share = static_cast<double>(lower_count) / static_cast<double>(lower_count + upper_count);
    low.reference_budget = cell.reference_budget * share;
    high.reference_budget = cell.reference_budget * (1.0 - share);
    return {low, high};
}

} // namespace glint
