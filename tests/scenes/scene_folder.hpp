// Where the scenes lie, and their text.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace glint::test {

[[nodiscard]] inline std::filesystem::path scene_folder() {
    return std::filesystem::path(GLINT_SOURCE_DIR) / "scenes" / "sdl";
}

/// The whole file; empty where it cannot be read.
[[nodiscard]] inline std::string text_of(const std::filesystem::path &path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace glint::test
