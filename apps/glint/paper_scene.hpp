// Finding the scene of the paper, which `glint bench table` measures when no other is named.
#pragma once

#include <filesystem>

#include <glint/result.hpp>

namespace glint::cli {

/// cornell.sdl where `make install` puts it relative to the executable, else in the source tree that the program was
/// built from. Fails with not_found, naming both places.
[[nodiscard]] Result<std::filesystem::path> find_paper_scene();

} // namespace glint::cli
