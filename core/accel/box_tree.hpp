// A hierarchy over boxes: of a scene's quadrics, and of its moving objects.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/box.hpp"

namespace glint {

/// Inner nodes have two children, side by side. A leaf is one box: what is in it costs more than to ask for the box.
struct BoxNode {
    Box bounds;
    uint32_t first; ///< of a leaf its place in `order`; else the first child
    uint32_t count; ///< 1 for a leaf, 0 for an inner node
};

/// Whether who looks along (x, y, z) meets the second box first.
inline bool is_second_nearer(const Box &first, const Box &second, float x, float y, float z) {
    const float along_x = (second.lo.x - first.lo.x) + (second.hi.x - first.hi.x);
    const float along_y = (second.lo.y - first.lo.y) + (second.hi.y - first.hi.y);
    const float along_z = (second.lo.z - first.lo.z) + (second.hi.z - first.hi.z);
    return x * along_x + y * along_y + z * along_z < 0.0f;
}

/// Leaves lie at most this deep.
inline constexpr uint32_t max_box_tree_depth = 68;

struct BoxTree {
    std::vector<BoxNode> nodes;  ///< node 0 is the root; empty over nothing
    std::vector<uint32_t> order; ///< the boxes' numbers, leaf after leaf
};

[[nodiscard]] BoxTree build_box_tree(std::span<const Box> boxes);

} // namespace glint
