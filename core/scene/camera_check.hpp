// Whether a camera can see: asked by the scene builder, and by the renderer when a program brings its own camera.
#pragma once

#include <optional>
#include <string>

#include <glint/scene.hpp>

namespace glint {

/// What is wrong with the camera, or nothing.
[[nodiscard]] std::optional<std::string> camera_problem(const Camera &camera);

} // namespace glint
