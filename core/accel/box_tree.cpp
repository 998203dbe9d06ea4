// Builds the hierarchy over boxes, as that of triangles is built.
#include "accel/box_tree.hpp"

#include <algorithm>

#include "accel/bvh/binary_bvh.hpp"
#include "accel/triangle_data.hpp"

namespace glint {

namespace {

/// Makes of a leaf of several boxes an inner node, with two leaves of half as many at the end of the list.
void halve(uint32_t leaf, BoxTree &tree, std::span<const Box> boxes) {
    const auto [bounds, first, count] = tree.nodes[leaf];
    if (count < 2) return;
    Box centres;
    const auto begin = tree.order.begin() + first, end = begin + count;
    for (auto box = begin; box != end; ++box) centres.extend(boxes[*box].lo + boxes[*box].hi);
    const glm::vec3 extent = centres.hi - centres.lo;
    const int axis = extent.x >= std::max(extent.y, extent.z) ? 0 : extent.y >= extent.z ? 1 : 2;
    std::sort(begin, end, [&](uint32_t a, uint32_t b) {
        const float at_a = boxes[a].lo[axis] + boxes[a].hi[axis], at_b = boxes[b].lo[axis] + boxes[b].hi[axis];
        return at_a < at_b || (at_a == at_b && a < b);
    });
    const auto add = [&](uint32_t from, uint32_t how_many) {
        Box around;
        for (uint32_t i = from; i < from + how_many; ++i) around.extend(boxes[tree.order[i]]);
        tree.nodes.push_back({around, from, how_many});
    };
    tree.nodes[leaf] = {bounds, static_cast<uint32_t>(tree.nodes.size()), 0};
    add(first, count / 2);
    add(first + count / 2, count - count / 2);
}

} // namespace

BoxTree build_box_tree(std::span<const Box> boxes) {
    BoxTree tree;
    if (boxes.empty()) return tree;
    // To the builder, which looks at bounds and their centres alone, a box is as good as a triangle across it.
    std::vector<TriangleCorners> across;
    for (const Box &box : boxes) across.push_back({box.lo, box.hi, box.lo});
    const BinaryBvh bvh = build_binary_bvh(across, 1);
    tree.order.assign(bvh.triangle_ids.begin(), bvh.triangle_ids.end());
    // Not all of the builder's places for nodes are used: number anew, so that none is empty.
    std::vector<uint32_t> built{0};
    for (uint32_t i = 0; i < built.size(); ++i) {
        const BinaryNode &node = bvh.nodes[built[i]];
        const Box box{{node.lo[0], node.lo[1], node.lo[2]}, {node.hi[0], node.hi[1], node.hi[2]}};
        const auto next = static_cast<uint32_t>(built.size());
        tree.nodes.push_back({box, node.is_leaf() ? node.first : next, node.count});
        if (!node.is_leaf()) built.insert(built.end(), {node.first, node.first + 1});
    }
    for (uint32_t i = 0; i < tree.nodes.size(); ++i) halve(i, tree, boxes);
    return tree;
}

} // namespace glint
