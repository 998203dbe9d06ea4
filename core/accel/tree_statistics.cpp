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
    AccelStatistics statistics;
    statistics.triangles = triangle_count;
    statistics.nodes = tree.nodes.size();
    statistics.references = tree.reference_count();
    const double root_area = tree.bounds.empty() ? 0.0 : tree.bounds.half_area();
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
            statistics.sah_cost += probability * CostModel::leaf(node.reference_count());
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

AccelStatistics measure_bvh(const WideBvh &bvh, uint32_t triangle_count) {
    AccelStatistics statistics;
    statistics.triangles = triangle_count;
    statistics.references = bvh.reference_count();
    const double root_area = bvh.bounds.half_area();
    struct Place {
        uint32_t node, depth;
        Box box;
    };
    std::vector<Place> stack{{0, 0, bvh.bounds}};
    while (!stack.empty()) {
        const Place place = stack.back();
        stack.pop_back();
        const auto probability = [&](const Box &box) { return root_area > 0.0 ? box.half_area() / root_area : 1.0; };
        ++statistics.nodes;
        statistics.sah_cost += probability(place.box);
        const WideNode &node = bvh.nodes[place.node];
        for (uint32_t i = 0; i < WideNode::width; ++i) {
            const ChildLink child(node.child[i]);
            if (child.word() == 0) continue;
            const auto &b = node.bounds;
            const Box box{{b[0][i], b[1][i], b[2][i]}, {b[3][i], b[4][i], b[5][i]}};
            if (child.is_leaf()) {
                ++statistics.nodes;
                ++statistics.leaves;
                statistics.depth = std::max(statistics.depth, place.depth + 1);
                statistics.sah_cost += probability(box);
            } else {
                stack.push_back({child.number(), place.depth + 1, box});
            }
        }
    }
    return statistics;
}

} // namespace glint
