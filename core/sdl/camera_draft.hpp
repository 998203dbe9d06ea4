// The camera that an SDL file's directives make together.
#pragma once

#include <optional>

#include <glint/scene.hpp>

#include "sdl/scene_draft.hpp"

namespace glint {

/// The camera, once the whole file was read; nothing where it cannot be made, after an error.
[[nodiscard]] std::optional<Camera> camera_of(const SceneDraft &draft, Problems &problems);

} // namespace glint
