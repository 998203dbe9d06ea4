// Whether a file lies inside a folder, whatever links and dots are on the way.
#pragma once

#include <filesystem>

namespace glint::cli {

/// Absolute, without dots and links, as far as it exists.
[[nodiscard]] std::filesystem::path real_path(const std::filesystem::path &path);

/// Whether `path` is the folder or something in it.
[[nodiscard]] bool is_inside(const std::filesystem::path &path, const std::filesystem::path &folder);

} // namespace glint::cli
