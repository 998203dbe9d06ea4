// What `glint inspect` prints, for people and for programs.
#pragma once

#include <string>

#include <glint/ray_tree.hpp>

namespace glint::cli {

/// `scene` is the scene file as the user named it.
[[nodiscard]] std::string ray_tree_text(const std::string &scene, const RayTree &tree);
[[nodiscard]] std::string ray_tree_json(const std::string &scene, const RayTree &tree);

} // namespace glint::cli
