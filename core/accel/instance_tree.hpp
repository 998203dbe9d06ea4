// A scene's moving meshes as rays find them: each with a tree in its own space, which never changes, and a small
// hierarchy over where they stand, which is made anew for each frame (Wald, Benthin & Slusallek 2003, "Distributed
// interactive ray tracing of dynamic scenes").
//
// What a ray hits is decided in the object's own space: origin and direction are taken there with float arithmetic
// (math/rigid.hpp), and the distance found there counts in the world, since nothing changes lengths. So an object at
// rest, with the identity for a pose, is hit where it would be if it could not move.
#pragma once

#include <cstdint>
#include <vector>

#include <glint/rigid_transform.hpp>
#include <glint/scene.hpp>

#include "accel/box_tree.hpp"
#include "accel/triangle_tree.hpp"

namespace glint {

/// A moving mesh.
struct Instance {
    RigidTransform pose;
    /// Of the object in the world, with room for all rounding that does not grow with the ray's own way.
    Box bounds;
    uint32_t first_triangle; ///< triangle_id, in the scene, of the first of its own triangles
    const KdNode *nodes;     ///< of its tree, as GeometryView has them; triangles count from 0
    const WideNode *wide_nodes;
    const uint32_t *leaf_words;
    uint32_t triangle_count;
    Box own_bounds; ///< in the object's space
    /// Lengths that were rounded on the way to a point of the surface are `length_factor` times the larger one of
    /// what a ray's own way has and `least_length`.
    float length_factor, least_length;
};
inline constexpr uint32_t no_instance = UINT32_MAX;

/// What does not change when an object moves.
struct Mover {
    uint32_t object;
    uint32_t first_triangle;
    uint32_t tree; ///< in a list of them; objects of one mesh share one
};

struct InstanceTree {
    std::vector<Instance> instances; ///< in the movers' order
    BoxTree over;                    ///< their boxes
    Box bounds;                      ///< of all, without room

    [[nodiscard]] static InstanceTree from(const Scene &scene, const std::vector<Mover> &movers,
                                           const std::vector<TriangleTree> &trees);
};

} // namespace glint
