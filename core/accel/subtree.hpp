// Builds the part of the tree below one cell, on one thread.
#pragma once

#include <vector>

#include "accel/kd_node.hpp"
#include "accel/partition.hpp"

namespace glint {

/// Nodes and the triangles of leaves, both numbered from the subtree's root and in depth-first order.
struct Subtree {
    std::vector<KdNode> nodes;
    std::vector<uint32_t> triangle_ids;
};

/// One for each thread: keeps its memory from one subtree to the next.
class SubtreeBuilder {
public:
    SubtreeBuilder(std::span<const TriangleCorners> triangles, const CostModel &cost)
        : cost_(cost), partition_(triangles) {}

    [[nodiscard]] Subtree build(const Cell &cell, std::span<const Reference> references);

private:
    void grow(Subtree &subtree, const Cell &cell, size_t first, size_t count, size_t top);

    CostModel cost_;
    Partition partition_;
    UninitializedVector<Reference> stack_;
};

} // namespace glint
