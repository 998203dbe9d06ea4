// What a node of the tree is expected to cost a ray: the numbers behind every decision of the builder.
#pragma once

#include <cstdint>

namespace glint {

/// Costs are in triangle tests. The values were chosen by measuring frames, not by counting instructions; how is in
/// docs/performance.md.
struct CostModel {
    /// Of walking through an inner node.
    static constexpr double traversal = 1.0;
    /// Of one group of triangle tests in a leaf.
    static constexpr double intersection = 0.7;
    /// Triangles that a leaf tests as one group: a partly filled group costs as much as a full one.
    static constexpr uint32_t leaf_group = 1;
    /// A split that cuts off empty space ends rays early, which the heuristic's "rays never stop" does not see: its
    /// cost is scaled by this.
    static constexpr double empty_space_factor = 0.9;

    [[nodiscard]] static double leaf(uint64_t triangle_count) {
        return intersection * static_cast<double>((triangle_count + leaf_group - 1) / leaf_group * leaf_group);
    }

    /// Of splitting a cell into two, each reached with the given probability and holding the given number of triangles.
    [[nodiscard]] static double split(double lower_probability, uint64_t lower_count, double upper_probability,
                                      uint64_t upper_count) {
        const double cost =
            traversal + (lower_probability * leaf(lower_count) + upper_probability * leaf(upper_count));
        return lower_count == 0 || upper_count == 0 ? empty_space_factor * cost : cost;
    }
};

} // namespace glint
