// Which folders hold which files, by their names alone.
#pragma once

#include <filesystem>

namespace glint {

/// The path as its letters say it: without "." and "..", where those can be resolved, and without a '/' at its end;
/// empty for the folder that it begins in.
[[nodiscard]] std::filesystem::path plain_path(const std::filesystem::path &path);

// Paths are absolute and without symbolic links, or those of a FileSource, and plain.

/// Whether the path is the folder or something in it.
[[nodiscard]] bool is_within(const std::filesystem::path &path, const std::filesystem::path &folder);

/// The innermost folder that holds them both; one of them where it holds the other.
[[nodiscard]] std::filesystem::path common_folder(const std::filesystem::path &a, const std::filesystem::path &b);

} // namespace glint
