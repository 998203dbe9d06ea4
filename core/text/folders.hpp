// Which folders hold which files, by their names alone.
#pragma once

#include <filesystem>

namespace glint {

// Paths are absolute and normal: no dots, no symbolic links.

/// Whether the path is the folder or something in it.
[[nodiscard]] bool is_within(const std::filesystem::path &path, const std::filesystem::path &folder);

/// The innermost folder that holds them both; one of them where it holds the other.
[[nodiscard]] std::filesystem::path common_folder(const std::filesystem::path &a, const std::filesystem::path &b);

} // namespace glint
