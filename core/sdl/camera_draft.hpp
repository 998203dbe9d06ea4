// The camera that an SDL file's directives make together.
#pragma once

#include <optional>

#include <glint/animation.hpp>
#include <glint/scene.hpp>

#include "sdl/scene_draft.hpp"
#include "text/problems.hpp"

namespace glint {

/// The camera, once the whole file was read; nothing where it cannot be made, after an error.
[[nodiscard]] std::optional<Camera> camera_of(const SceneDraft &draft, Problems &problems);

/// What a camera with a target sees of it from anywhere.
[[nodiscard]] EyeMotion::View view_of(const SceneDraft &draft);

} // namespace glint
