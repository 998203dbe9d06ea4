// Builds the hierarchy over boxes, as that of triangles is built.
#include "accel/box_tree.hpp"

#include "accel/bvh/binary_bvh.hpp"
#include "accel/triangle_data.hpp"

namespace glint {

BoxTree build_box_tree(std::span<const Box> boxes) {
    BoxTree tree;
    if (boxes.empty()) return tree;
    // To the builder, which looks at bounds and their centres alone, a box is as good as a triangle across it.
    std::vector<TriangleCorners> across;
    for (const Box &box : boxes) across.push_back({box.lo, box.hi, box.lo});
    const BinaryBvh bvh = build_binary_bvh(across, 1);
    // Not all of the builder's places for nodes are used: number anew, so that none is empty.
    std::vector<uint32_t> built{0};
    for (uint32_t i = 0; i < built.size(); ++i) {
        const BinaryNode &node = bvh.nodes[built[i]];
        const Box box{{node.lo[0], node.lo[1], node.lo[2]}, {node.hi[0], node.hi[1], node.hi[2]}};
        const auto next = static_cast<uint32_t>(built.size());
        tree.nodes.push_back({box, node.is_leaf() ? node.first : next, node.count});
        if (!node.is_leaf()) built.insert(built.end(), {node.first, node.first + 1});
    }
    tree.order.assign(bvh.triangle_ids.begin(), bvh.triangle_ids.end());
    return tree;
}

} // namespace glint
