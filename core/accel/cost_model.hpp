// What a node of the tree is expected to cost a ray: the numbers behind every decision of the builder.
#pragma once

#include <cstdint>

namespace glint {

/// Costs are in steps through inner nodes. The values were chosen by counting instructions, measuring frames and
/// weighing memory; the figures are in docs/performance.md.
class CostModel {
public:
    /// Of walking through an inner node: the unit.
    static constexpr double traversal = 1.0;
    /// A split that cuts off empty space ends rays early, which the heuristic's "rays never stop" does not see: its
    /// cost is scaled by this.
    static constexpr double empty_space_factor = 0.9;
    /// Triangles that a leaf tests as one group: a partly filled group costs as much as a full one. The scalar kernel
    /// tests one by one.
    static constexpr uint32_t leaf_group = 1;

    /// While the whole tree stays in a cache near the core, triangle tests are what counts, and smaller leaves pay. In
    /// a large tree a step is a cache miss and each further node is memory: larger leaves do.
    explicit CostModel(uint64_t triangle_count) : intersection_(triangle_count <= 10'000 ? 2.0 : 0.7) {}

    [[nodiscard]] double leaf(uint64_t triangle_count) const {
        return intersection_ * static_cast<double>((triangle_count + leaf_group - 1) / leaf_group * leaf_group);
    }

    /// Of splitting a cell into two, each reached with the given probability and holding the given number of triangles.
    [[nodiscard]] double split(double lower_probability, uint64_t lower_count, double upper_probability,
                               uint64_t upper_count) const {
        const double cost = traversal + (lower_probability * leaf(lower_count) + upper_probability * leaf(upper_count));
        return lower_count == 0 || upper_count == 0 ? empty_space_factor * cost : cost;
    }

private:
    double intersection_;
};

} // namespace glint
