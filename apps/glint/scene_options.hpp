// The options of every command that reads a scene, and the reading itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <glint/read.hpp>

#include "number_options.hpp"

namespace glint::cli {

struct SceneOptions {
    std::string file; ///< as the user named it
    std::string scene_root;
    std::string dialect;
    std::optional<uint64_t> max_pixels;
    bool allow_outside_root = false;
    bool flat = false;

    /// For the scene file at `path`.
    [[nodiscard]] ReadOptions read_options(const std::filesystem::path &path) const;
    /// The folder that no path in the scene file at `path` may leave: --scene-root; else the current folder, if the
    /// scene lies inside it; else the scene's own.
    [[nodiscard]] std::filesystem::path root_for(const std::filesystem::path &path) const;
    /// Most pixels a picture may have, asked for by the scene or by a flag.
    [[nodiscard]] uint64_t pixel_limit() const { return max_pixels.value_or(SceneLimits{}.max_pixels); }
};

/// Adds --max-pixels, --scene-root, --allow-outside-root, --dialect and --flat. `options` must live as long as the
/// parser.
void add_scene_options(CLI::App &parser, SceneOptions &options);

/// Says the file's warnings on standard error.
void complain_about(const SceneFile &file);

} // namespace glint::cli
