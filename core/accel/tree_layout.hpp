// Lays the parts of a tree out in the order that traversal reads.
#pragma once

#include <vector>

#include "accel/kd_tree.hpp"
#include "accel/subtree.hpp"
#include "accel/top_of_tree.hpp"
#include "threads/crew.hpp"

namespace glint {

/// Joins a top and the subtrees of its cells to a tree. Its bounds are left to the caller.
[[nodiscard]] KdTree lay_out(const TopOfTree &top, const std::vector<Subtree> &subtrees,
                             std::span<const TriangleCorners> triangles, const Crew &crew);

} // namespace glint
