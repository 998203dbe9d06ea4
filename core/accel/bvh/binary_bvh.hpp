// A binary bounding volume hierarchy, from which the wide one is made.
#pragma once

#include <cstdint>
#include <span>

#include "accel/triangle_data.hpp"
#include "accel/uninitialized_vector.hpp"
#include "math/box.hpp"
#include "threads/crew.hpp"

namespace glint {

struct BinaryNode {
    float lo[3];
    uint32_t first; ///< of a leaf its first place in `triangle_ids`; else the left child, with the right one next
    float hi[3];
    uint32_t count; ///< triangles of a leaf; 0 for inner nodes

    [[nodiscard]] bool is_leaf() const { return count != 0; }
    [[nodiscard]] float half_area() const {
        const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        return x * y + (y * z + z * x);
    }
};

struct BinaryBvh {
    UninitializedVector<BinaryNode> nodes;      ///< node 0 is the root; some places between nodes are not used
    UninitializedVector<uint32_t> triangle_ids; ///< leaf after leaf
};

/// Leaves of the binary hierarchy, and so of the wide one, hold at most this many triangles.
inline constexpr uint32_t max_bvh_leaf = 8;
/// They lie at most this deep.
inline constexpr uint32_t max_binary_depth = 64;

/// Top down; splits minimise the surface area heuristic over bins of the triangles' centres (Wald 2007, "On fast
/// construction of SAH-based bounding volume hierarchies"). The result does not depend on the number of threads.
[[nodiscard]] BinaryBvh build_binary_bvh(std::span<const TriangleCorners> triangles, const Crew &crew);

} // namespace glint
