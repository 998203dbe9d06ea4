// What a node of the tree is expected to cost a ray: the numbers behind every decision of the builder.
#pragma once

#include <cstdint>

namespace glint {

/// Costs are in steps through inner nodes. The values were chosen by counting instructions, measuring frames and
/// weighing memory; the figures are in docs/performance.md.
struct CostModel {
    /// Of walking through an inner node: the unit.
    static constexpr float traversal = 1.0f;
    /// A split that cuts off empty space ends rays early, which the heuristic's "rays never stop" does not see: its
    /// cost is scaled by this.
    static constexpr float empty_space_factor = 0.9f;
    /// Triangles that a leaf tests as one group: a partly filled group costs as much as a full one.
    static constexpr int32_t log2_leaf_group = 3, leaf_group = 1 << log2_leaf_group;
    static constexpr float per_triangle = 0.1f, per_group = 1.0f;

    // Counts are signed and nothing branches, so that compilers can do many at a time.

    [[nodiscard]] static float leaf(int32_t triangle_count) {
        const int32_t groups = (triangle_count + (leaf_group - 1)) >> log2_leaf_group;
        return per_triangle * static_cast<float>(triangle_count) + per_group * static_cast<float>(groups);
    }

    /// Of splitting a cell into two, each reached with the given probability and holding the given number of triangles.
    [[nodiscard]] static float split(float lower_probability, int32_t lower_count, float upper_probability,
                                     int32_t upper_count) {
        const float cost = traversal + (lower_probability * leaf(lower_count) + upper_probability * leaf(upper_count));
        const int32_t fewer = lower_count < upper_count ? lower_count : upper_count;
        return cost * (fewer == 0 ? empty_space_factor : 1.0f);
    }

    /// Whether dividing so many triangles can pay. The best that can be had is one triangle left for every ray.
    [[nodiscard]] static bool may_pay(int32_t triangle_count) { return leaf(triangle_count) > traversal + leaf(1); }
};

} // namespace glint
