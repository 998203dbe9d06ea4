// Finding the scenes that come with Glint, by name.
#pragma once

#include <filesystem>
#include <string>

#include <glint/result.hpp>

namespace glint::cli {

/// `name` itself where there is such a file, or where it is not a bare word; else the scene of that name, with .sdl
/// added, where `make install` puts it relative to the executable or in the source tree that the program was built from.
/// The empty name is the paper's scene, cornell. Fails with not_found, naming the places.
[[nodiscard]] Result<std::filesystem::path> find_scene(const std::string &name);

} // namespace glint::cli
