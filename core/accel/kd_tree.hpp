// The finished kd-tree: arrays that traversal reads.
#pragma once

#include <cstdint>
#include <vector>

#include <glint/accel.hpp>

#include "accel/kd_node.hpp"
#include "accel/triangle_data.hpp"
#include "math/box.hpp"

namespace glint {

struct KdTree {
    Box bounds;                       ///< of all triangles
    std::vector<KdNode> nodes;        ///< depth-first; node 0 is the root. Empty for AccelKind::brute
    std::vector<uint32_t> references; ///< triangle ids, leaf after leaf
};

/// Leaves lie at most this deep, so that a traversal's stack has a fixed size.
inline constexpr uint32_t max_tree_depth = 60;

/// Builds the tree over triangles that all have an area. The result does not depend on the number of threads.
///
/// Splits minimise the surface area heuristic (MacDonald & Booth 1990). Triangles that straddle a split are clipped to
/// each side ("perfect splits", Havran 2001), so that the heuristic counts only cells that a triangle really enters.
/// Large nodes look at evenly spaced planes (binning, Popov et al. 2006, "Experiences with Streaming Construction of
/// SAH KD-Trees"), small ones at every triangle boundary (Wald & Havran 2006, "On building fast kd-Trees for Ray
/// Tracing, and on doing that in O(N log N)").
[[nodiscard]] KdTree build_kd_tree(const std::vector<TriangleCorners> &triangles, unsigned threads);

} // namespace glint
