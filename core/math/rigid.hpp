// Points and vectors between an object's own space and the world, by a rotation and a translation. Every rounding is
// pinned down; the identity changes no bit (but the sign of zeros).
#pragma once

#include <glint/rigid_transform.hpp>

#include "math/box.hpp"
#include "math/vec.hpp"

namespace glint {

/// The axes are orthonormal, so that their transpose is the inverse.
[[nodiscard]] inline glm::vec3 vector_to_object(const RigidTransform &pose, const glm::vec3 &v) {
    return {dot(pose.x, v), dot(pose.y, v), dot(pose.z, v)};
}
[[nodiscard]] inline glm::vec3 point_to_object(const RigidTransform &pose, const glm::vec3 &p) {
    const glm::vec3 from_origin = {p.x - pose.translation.x, p.y - pose.translation.y, p.z - pose.translation.z};
    return vector_to_object(pose, from_origin);
}
[[nodiscard]] inline glm::vec3 vector_to_world(const RigidTransform &pose, const glm::vec3 &v) {
    return {(pose.x.x * v.x + pose.y.x * v.y) + pose.z.x * v.z, (pose.x.y * v.x + pose.y.y * v.y) + pose.z.y * v.z,
            (pose.x.z * v.x + pose.y.z * v.y) + pose.z.z * v.z};
}

/// The world's box around an object's (Arvo 1990, "Transforming axis-aligned bounding boxes", in Glassner, "Graphics
/// gems"), but for rounding.
[[nodiscard]] inline Box box_to_world(const RigidTransform &pose, const Box &box) {
    Box moved{pose.translation, pose.translation};
    for (int axis = 0; axis < 3; ++axis) {
        double lo = pose.translation[axis], hi = lo;
        const float along[3] = {pose.x[axis], pose.y[axis], pose.z[axis]};
        for (int own = 0; own < 3; ++own) {
            const double a = double(along[own]) * box.lo[own], b = double(along[own]) * box.hi[own];
            lo += a < b ? a : b;
            hi += a < b ? b : a;
        }
        moved.lo[axis] = static_cast<float>(lo);
        moved.hi[axis] = static_cast<float>(hi);
    }
    return moved;
}

} // namespace glint
