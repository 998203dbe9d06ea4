// What an animation must fulfil.
#pragma once

#include <vector>

#include <glint/animation.hpp>

#include "scene/scene_check.hpp"

namespace glint {

/// Keeps every complaint about an animation of these objects.
void check_animation(const Animation &animation, const std::vector<Object> &objects, SceneChecker &check);

} // namespace glint
