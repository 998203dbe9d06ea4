// Builds the part of the tree below one cell, on one thread.
#pragma once

#include <utility>
#include <vector>

#include "accel/kd_node.hpp"
#include "accel/partition.hpp"
#include "accel/split_search.hpp"

namespace glint {

/// Nodes and the triangles of leaves, both numbered from the subtree's root and in depth-first order.
struct Subtree {
    std::vector<KdNode> nodes;
    std::vector<uint32_t> triangle_ids;
};

/// One for each thread: keeps its memory from one subtree to the next.
class SubtreeBuilder {
public:
    explicit SubtreeBuilder(std::span<const TriangleCorners> triangles) : partition_(triangles) {}

    [[nodiscard]] Subtree build(const Cell &cell, std::span<const Reference> references);

private:
    /// References on the stack, and where it is free from.
    struct Range {
        size_t first, count, top;
    };

    void grow(Subtree &subtree, const Cell &cell, Range range);
    void grow_counted(Subtree &subtree, const Cell &cell, Range range);
    std::pair<Range, Range> divide(Range range, const Split &split);
    void add_leaf(Subtree &subtree, Range range) const;

    SplitSearch search_;
    Partition partition_;
    UninitializedVector<Reference> stack_;
};

} // namespace glint
