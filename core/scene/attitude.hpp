// Rotations as unit quaternions, in double: what lies between two of them.
#pragma once

#include <glint/rigid_transform.hpp>

namespace glint {

/// Unit quaternion w + x i + y j + z k.
struct Attitude {
    double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
};

/// A turn about an axis of any length but 0.
[[nodiscard]] Attitude attitude_of(const glm::vec3 &axis, double angle_rad);
/// The attitude at a share of the way from a to b, the shorter way at even speed (Shoemake 1985, "Animating rotation
/// with quaternion curves").
[[nodiscard]] Attitude between(const Attitude &a, const Attitude &b, double share);
/// A turn about the pivot, then a move; rounded once.
[[nodiscard]] RigidTransform pose_of(const Attitude &attitude, const glm::vec3 &pivot, const glm::vec3 &moved_by);

} // namespace glint
