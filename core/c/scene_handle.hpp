// The handle of a scene, and what the other parts of the C interface need of it.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <glint/accel.hpp>
#include <glint/scene.h>
#include <glint/scene.hpp>

#include "c/handle.hpp"

struct glint_scene : glint::HandleOf<glint::HandleKind::scene> {
    [[nodiscard]] bool is_made() const { return scene != nullptr; }
    /// Takes what was made, or keeps what went wrong.
    glint_error take(glint::Result<std::shared_ptr<const glint::Scene>> made);
    glint_error fail_with(glint::Error error);

    std::shared_ptr<const glint::Scene> scene;
    std::vector<glint::Diagnostic> diagnostics;
    std::string dialect, dialect_reason, output_file;

    /// Trees of this scene that renderers have: the next renderer with threads of our own shares them.
    mutable std::mutex accels_lock;
    mutable std::weak_ptr<const glint::Accel> accels[4];
};

namespace glint {

static_assert(sizeof(Point) == 3 * sizeof(float));

[[nodiscard]] inline glm::vec3 vec3_of(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}
inline void store(const glm::vec3 &v, float (&to)[3]) {
    to[0] = v.x, to[1] = v.y, to[2] = v.z;
}

[[nodiscard]] Camera camera_of(const glint_camera &camera);
[[nodiscard]] glint_camera c_camera_of(const Camera &camera);
[[nodiscard]] RigidTransform pose_of(const glint_pose &pose);
[[nodiscard]] glint_pose c_pose_of(const RigidTransform &pose);

} // namespace glint
