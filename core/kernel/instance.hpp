// Moving objects as rays meet them: a ray is taken into the object's own space, and what it meets there at t, it meets.
#pragma once

#include <cstdint>

#include "accel/instance_tree.hpp"
#include "kernel/walk_boxes.hpp"
#include "math/rigid.hpp"

namespace glint {

/// An InstanceTree as the kernels see it.
struct InstanceView {
    const Instance *all;
    const uint32_t *order; ///< places in `all`, as the nodes' leaves have them
    const BoxNode *nodes;
    const uint32_t *of_surface; ///< place in `all`, or no_instance, by surface; empty where there are none
    uint32_t count;

    /// What the surface belongs to, or nullptr.
    [[nodiscard]] const Instance *by_surface(uint32_t surface) const {
        if (count == 0 || of_surface[surface] == no_instance) return nullptr;
        return all + of_surface[surface];
    }
};

/// How much wider than for triangles the boxes of instances are for a ray: the way into an object's space is some
/// roundings of the ray's own way longer.
inline constexpr float instance_slack = 4.0f;

inline Ray ray_to_object(const RigidTransform &pose, const Ray &ray) {
    return {point_to_object(pose, ray.org), vector_to_object(pose, ray.dir)};
}

/// Calls visit(instance) for every instance that the ray may meet before search_end(t_max), until a call returns true.
/// `visit` may lower t_max.
template <typename Visit>
void walk_instances(const InstanceView &instances, const PreparedRay &ray, const float &t_max, Visit &&visit) {
    if (instances.count == 0) return;
    PreparedRay wide = ray;
    for (int axis = 0; axis < 3; ++axis) wide.parameter_slack[axis] *= instance_slack;
    walk_boxes(instances.nodes, wide, t_max, [&](uint32_t i) { return visit(instances.all[instances.order[i]]); });
}

} // namespace glint
