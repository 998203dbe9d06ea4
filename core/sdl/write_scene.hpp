// From a draft back to SDL text, in the canonical dialect.
#pragma once

#include <string>

#include "sdl/file_names.hpp"
#include "sdl/scene_draft.hpp"
#include "text/problems.hpp"

namespace glint {

/// The text of a scene file in the dialect `glint` that says what the draft, of a whole file, holds: numbers read back
/// as the same floats. Settings stand in a fixed order, those that have their default value are left out but for a few
/// that every picture is asked about; lights and objects keep their order. Meshes that cannot be named are reported.
[[nodiscard]] std::string write_scene(const SceneDraft &draft, FileNames &names, Problems &problems);

} // namespace glint
