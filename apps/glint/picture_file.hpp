// Where the render command writes when the user does not say.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <glint/read.hpp>
#include <glint/result.hpp>

#include "scene_options.hpp"

namespace glint::cli {

/// The scene's own `output`, a path relative to the scene file's folder: the text of a scene may come from anywhere, so
/// it may not leave the scene root unless the user allowed that. Without one, the scene's name with .png in the current
/// folder. Fails with bad_input.
[[nodiscard]] Result<std::filesystem::path> default_picture_file(const SceneOptions &options, const SceneFile &scene);

} // namespace glint::cli
