// Measures a finished tree.
#include "accel/tree_statistics.hpp"

#include <algorithm>

#include "accel/cost_model.hpp"
#include "math/vec.hpp"

namespace glint {

namespace {

struct Visit {
    uint32_t node;
    uint32_t depth;
    Box cell;
};

} // namespace

AccelStatistics measure_tree(const KdTree &tree, uint32_t triangle_count) {
    const CostModel cost(triangle_count);
    AccelStatistics statistics;
    statistics.triangles = triangle_count;
    statistics.nodes = tree.nodes.size();
    statistics.references = tree.reference_count();
    const double root_area = tree.bounds.half_area();
    std::vector<Visit> stack;
    if (!tree.nodes.empty()) stack.push_back({0, 0, tree.bounds});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const KdNode &node = tree.nodes[visit.node];
        const double probability = root_area > 0.0 ? visit.cell.half_area() / root_area : 1.0;
        if (node.is_leaf()) {
            ++statistics.leaves;
            if (node.reference_count() == 0) ++statistics.empty_leaves;
            statistics.depth = std::max(statistics.depth, visit.depth);
            statistics.sah_cost += probability * cost.leaf(node.reference_count());
            continue;
        }
        statistics.sah_cost += probability * CostModel::traversal;
        Box lower = visit.cell, upper = visit.cell;
        const auto axis = static_cast<int>(node.axis());
        component(lower.hi, axis) = component(upper.lo, axis) = node.split();
        stack.push_back({visit.node + 1, visit.depth + 1, lower});
        stack.push_back({node.upper_child(), visit.depth + 1, upper});
    }
    return statistics;
}

} // namespace glint
