// Split search for large nodes: count triangles in evenly spaced bins, look at the planes between them.
#include "accel/split.hpp"

#include <array>

namespace glint {

namespace {

constexpr int bin_count = 64;

/// How many references begin and end in each bin along one axis.
struct Bins {
    std::array<uint32_t, bin_count> begin{};
    std::array<uint32_t, bin_count> end{};
};

} // namespace

Split find_binned_split(std::span<const Reference> references, const Box &cell, const CostModel &cost) {
    std::array<Bins, 3> bins;
    Box occupied;
    const glm::vec3 extent = cell.hi - cell.lo;
    glm::vec3 scale(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        if (component(extent, axis) > 0.0f) component(scale, axis) = bin_count / component(extent, axis);
    }
    const auto bin_of = [&](int axis, float position) {
        const float bin = (position - component(cell.lo, axis)) * component(scale, axis);
        return bin >= bin_count - 1 ? bin_count - 1 : bin > 0.0f ? static_cast<int>(bin) : 0; // NaN lands in 0
    };
    std::array<uint64_t, 3> in_low_face{}, in_high_face{};
    for (const Reference &reference : references) {
        occupied.extend(reference.bounds);
        for (int axis = 0; axis < 3; ++axis) {
            in_low_face[axis] += component(reference.bounds.hi, axis) == component(cell.lo, axis);
            in_high_face[axis] += component(reference.bounds.lo, axis) == component(cell.hi, axis);
            ++bins[axis].begin[bin_of(axis, component(reference.bounds.lo, axis))];
            ++bins[axis].end[bin_of(axis, component(reference.bounds.hi, axis))];
        }
    }

    BestSplit best(cell, cost);
    const uint64_t count = references.size();
    for (int axis = 0; axis < 3; ++axis) {
        best.offer(axis, component(cell.lo, axis), 0, in_low_face[axis], count - in_low_face[axis]);
        best.offer(axis, component(cell.hi, axis), count - in_high_face[axis], in_high_face[axis], 0);
        best.offer(axis, component(occupied.lo, axis), 0, 0, count);
        best.offer(axis, component(occupied.hi, axis), count, 0, 0);
        uint64_t begun = 0, ended = 0;
        for (int plane = 1; plane < bin_count; ++plane) {
            begun += bins[axis].begin[plane - 1];
            ended += bins[axis].end[plane - 1];
            const float position =
                component(cell.lo, axis) + component(extent, axis) * (static_cast<float>(plane) / bin_count);
            best.offer(axis, position, begun, 0, count - ended);
        }
    }
    return best.best();
}

} // namespace glint
