// Makes a binary hierarchy better than splitting from the top down can.
#pragma once

#include "accel/bvh/binary_bvh.hpp"

namespace glint {

/// Takes those subtrees that have the largest boxes out, one after another, and puts each where it makes the boxes
/// around it grow least (Bittner, Hapala & Havran 2013, "Fast insertion-based optimization of bounding volume
/// hierarchies"). Leaves keep their triangles; the tree stays within max_binary_depth.
void reinsert_large_nodes(BinaryBvh &bvh);

} // namespace glint
