// Moving the objects of a finished scene: every edit is a scene of its own that shares the meshes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <glint/export.hpp>
#include <glint/result.hpp>
#include <glint/rigid_transform.hpp>
#include <glint/scene.hpp>

namespace glint {

/// A new place for a moving object.
struct ObjectPose {
    uint32_t object = 0; ///< into objects(), one that has a pose
    RigidTransform pose;
};

/// The scene with these objects, of which each had a pose already, moved there; the others stay. Costs a copy of the
/// lists of objects and lights: meshes and textures are shared. Accel::update() and Renderer::set_accel() go on from
/// there.
/// Fails, naming each, where an object is not there or does not move, and where a pose is not finite, lies more than
/// max_coordinate away, or is not a rotation to within 1e-4; what is left of that is rounded away.
[[nodiscard]] GLINT_API Result<std::shared_ptr<const Scene>> with_poses(const std::shared_ptr<const Scene> &scene,
                                                                        std::span<const ObjectPose> poses);

} // namespace glint
