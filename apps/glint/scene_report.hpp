// What `glint info` prints, for people and for programs.
#pragma once

#include <string>

#include <glint/accel.hpp>
#include <glint/read.hpp>

namespace glint::cli {

/// `name` is the scene file as the user named it; `accel` was built over the file's scene.
[[nodiscard]] std::string scene_report_text(const std::string &name, const SceneFile &file, const Accel &accel);
[[nodiscard]] std::string scene_report_json(const std::string &name, const SceneFile &file, const Accel &accel);

} // namespace glint::cli
