// Chooses between splits, and what follows from one.
#include "accel/split.hpp"

namespace glint {

Slices::Slices(const Box &cell, int axis) : lo(component(cell.lo, axis)), hi(component(cell.hi, axis)) {
    const glm::dvec3 extent = glm::dvec3(cell.hi) - glm::dvec3(cell.lo);
    const double e1 = extent[(axis + 1) % 3], e2 = extent[(axis + 2) % 3];
    const double area = cell.half_area();
    // A cell without area (flat in two directions) cannot be judged: every slice counts as met for certain.
    cap = area > 0.0 ? static_cast<float>(e1 * e2 / area) : 1.0f;
    girth = area > 0.0 ? static_cast<float>((e1 + e2) / area) : 0.0f;
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

Split find_empty_space(std::span<const Reference> references, const Box &cell, const CostModel &cost) {
    Box occupied;
    for (const Reference &reference : references) occupied.extend(reference.bounds);
    const auto count = static_cast<uint32_t>(references.size());
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        const Slices slices(cell, axis);
        const float lo = component(occupied.lo, axis), hi = component(occupied.hi, axis);
        if (lo > slices.lo) {
            const float c = cost.split(0.0f, 0, slices.upper_share(lo), count);
            if (c < best.cost) best = {c, lo, axis, false, 0, count};
        }
        if (hi < slices.hi) {
            const float c = cost.split(slices.lower_share(hi), count, 0.0f, 0);
            if (c < best.cost) best = {c, hi, axis, true, count, 0};
        }
    }
    return best;
}

Split choose_split(std::span<const Reference> references, const Cell &cell, const CostModel &cost) {
    if (references.empty() || cell.levels_left == 0) return {};
    const auto count = static_cast<uint32_t>(references.size());
    const Split split = !cost.may_pay(count)   ? find_empty_space(references, cell.box, cost)
                        : count <= exact_limit ? find_exact_split(references, cell.box, cost)
                                               : find_binned_split(references, cell.box, cost);
    const bool pays = split.cost < cost.leaf(count);
    const bool fits = static_cast<double>(split.lower) + split.upper <= cell.reference_budget;
    return pays && fits ? split : Split{};
}

} // namespace glint
