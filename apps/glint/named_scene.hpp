// Finding the scenes that come with Glint, by name.
#pragma once

#include <filesystem>
#include <string>

#include <glint/result.hpp>

namespace glint::cli {

/// `name` itself where there is such a file, or where it is not a bare word; else the scene of that name, with .sdl
/// added, where `make install` puts it relative to the executable or in the source tree that the program was built
/// from. The empty name is the paper's scene, cornell. Fails with not_found, naming the places.
[[nodiscard]] Result<std::filesystem::path> find_scene(const std::string &name);

/// How a report calls the scene that the user named.
[[nodiscard]] inline std::string scene_name(const std::string &name) {
    return name.empty() ? "cornell.sdl" : name;
}

} // namespace glint::cli
