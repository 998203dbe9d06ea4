// Which nodes of the binary hierarchy become the children of a wide node.
#pragma once

#include <array>

#include "accel/bvh/binary_bvh.hpp"
#include "accel/bvh/wide_bvh.hpp"

namespace glint {

/// Chooses so that the wide nodes together have the least area, and a random ray meets the fewest of them (Ylitie,
/// Karras & Laine 2017, "Efficient incoherent ray traversal on GPUs through compressed wide BVHs", section 3.1). Leaves
/// stay what they are.
class Collapse {
public:
    explicit Collapse(const BinaryBvh &binary);

    /// The children of the wide node that stands for a binary one, which is a leaf's only where it is the root. Returns
    /// how many.
    uint32_t children_of(uint32_t node, std::array<uint32_t, WideNode::width> &children) const;

private:
    /// [i]: the least area that the wide nodes of a subtree have, if it may become up to i + 1 children of the node
    /// above.
    using Areas = std::array<float, WideNode::width - 1>;

    /// So many children, of which so many are the left subtree's.
    struct Shares {
        float area;
        uint32_t left;
    };

    void measure(uint32_t node);
    [[nodiscard]] Shares share(uint32_t node, uint32_t count) const;
    void choose(uint32_t node, uint32_t most, std::array<uint32_t, WideNode::width> &children, uint32_t &count) const;

    const BinaryBvh &binary_;
    UninitializedVector<Areas> areas_; ///< of binary nodes
};

} // namespace glint
