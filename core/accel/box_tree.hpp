// A hierarchy over boxes: of a scene's quadrics, and of its moving objects.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/box.hpp"

namespace glint {

/// Inner nodes have two children, side by side.
struct BoxNode {
    Box bounds;
    uint32_t first; ///< of a leaf its first place in `order`; else the first child
    uint32_t count; ///< boxes of a leaf; 0 for inner nodes
};

/// Leaves lie at most this deep.
inline constexpr uint32_t max_box_tree_depth = 64;

struct BoxTree {
    std::vector<BoxNode> nodes;  ///< node 0 is the root; empty over nothing
    std::vector<uint32_t> order; ///< the boxes' numbers, leaf after leaf
};

[[nodiscard]] BoxTree build_box_tree(std::span<const Box> boxes);

} // namespace glint
