// Whether a pose is a rotation and a translation.
#pragma once

#include <optional>
#include <string>

#include <glint/rigid_transform.hpp>

namespace glint {

/// What is wrong with the pose, or nothing; then its axes are made orthonormal to within rounding.
[[nodiscard]] std::optional<std::string> straighten(RigidTransform &pose);

} // namespace glint
