// Where the texts of the fuzzers lie: beside the small meshes of scene/.
#pragma once

#include <filesystem>

#include <glint/read.hpp>

namespace glint::fuzz {

[[nodiscard]] inline std::filesystem::path scene_folder() {
    return GLINT_SOURCE_DIR "/tests/fuzz/scene";
}

/// Which does not exist.
[[nodiscard]] inline std::filesystem::path scene_file() {
    return scene_folder() / "fuzz.sdl";
}

[[nodiscard]] inline ReadOptions scene_options() {
    ReadOptions options;
    options.limits.max_triangles = 10'000;
    // One grey texel, whatever the file is: it is not image files that are tried here.
    options.read_texture = [](const std::filesystem::path &) { return Texture{1, 1, {Color(0.5f)}}; };
    return options;
}

} // namespace glint::fuzz
