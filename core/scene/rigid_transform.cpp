// Rotations from an axis and an angle, and what is left of one that others have rounded.
#include <glint/rigid_transform.hpp>

#include <cmath>

#include "math/vec.hpp"
#include "scene/attitude.hpp"
#include "scene/rigid_check.hpp"
#include "scene/scene_check.hpp"

namespace glint {

namespace {

double dot(const glm::dvec3 &a, const glm::dvec3 &b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
glm::dvec3 cross(const glm::dvec3 &a, const glm::dvec3 &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
glm::dvec3 normalized(const glm::dvec3 &a) {
    return a * (1.0 / std::sqrt(dot(a, a)));
}

} // namespace

RigidTransform RigidTransform::turned(const glm::vec3 &axis, double angle_rad, const glm::vec3 &pivot,
                                      const glm::vec3 &moved_by) {
    return pose_of(attitude_of(axis, angle_rad), pivot, moved_by);
}

std::optional<std::string> straighten(RigidTransform &pose) {
    constexpr double tolerance = 1e-4;
    if (!is_place(pose.translation)) return "its translation is not finite or reaches beyond 1e12";
    const glm::dvec3 x(pose.x), y(pose.y), z(pose.z);
    const glm::dvec3 off = cross(x, y) - z;
    // Written so that NaN fails.
    const bool is_rotation = std::abs(dot(x, x) - 1.0) <= tolerance && std::abs(dot(y, y) - 1.0) <= tolerance &&
                             std::abs(dot(x, y)) <= tolerance && max_abs(off) <= tolerance;
    if (!is_rotation) return "its axes are not of unit length, at right angles and right-handed";
    const glm::dvec3 first = normalized(x), second = normalized(y - first * dot(first, y));
    pose.x = glm::vec3(first);
    pose.y = glm::vec3(second);
    pose.z = glm::vec3(cross(first, second));
    return std::nullopt;
}

} // namespace glint
