// The finished kd-tree: arrays that traversal reads.
#pragma once

#include <cstdint>
#include <span>

#include <glint/accel.hpp>

#include "accel/kd_node.hpp"
#include "accel/leaf_triangles.hpp"
#include "accel/triangle_data.hpp"
#include "accel/uninitialized_vector.hpp"
#include "math/box.hpp"
#include "threads/crew.hpp"

namespace glint {

struct KdTree {
    Box bounds;                               ///< of all triangles
    UninitializedVector<KdNode> nodes;        ///< depth-first; node 0 is the root
    UninitializedVector<uint32_t> leaf_words; ///< triangles, leaf after leaf: see leaf_triangles.hpp

    [[nodiscard]] LeafTriangles leaf(const KdNode &node) const {
        return {leaf_words.data(), node.first_reference(), node.reference_count()};
    }
    [[nodiscard]] size_t reference_count() const { return (leaf_words.size() - leaf_padding) / words_per_reference; }
};

/// Leaves lie at most this deep, so that a traversal's stack has a fixed size.
inline constexpr uint32_t max_tree_depth = 60;

/// Builds the tree over triangles that all have an area. The result does not depend on the number of threads.
///
/// Splits minimise the surface area heuristic (MacDonald & Booth 1990) over planes found by binning (split_search.hpp).
/// Triangles that straddle a split are cut at it ("perfect splits", Havran 2001), so that the heuristic counts only
/// cells that a triangle really enters. All threads work on the top of the tree together (top_of_tree.hpp), then each
/// on subtrees of its own (subtree.hpp).
[[nodiscard]] KdTree build_kd_tree(std::span<const TriangleCorners> triangles, const Crew &crew);

/// A tree that is a single leaf: every ray meets every triangle.
[[nodiscard]] KdTree single_leaf_tree(std::span<const TriangleCorners> triangles);

} // namespace glint
