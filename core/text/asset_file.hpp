// Finding and reading a file that another file names, with the problems at the place where it is named.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "text/asset_paths.hpp"
#include "text/problems.hpp"
#include "text/text_file.hpp"

namespace glint {

/// The file that `name` at `place` stands for. Why there is none is reported.
[[nodiscard]] std::optional<std::filesystem::path> find_asset(const AssetPaths &paths, std::string_view name,
                                                              const Place &place, Problems &problems);

/// The text of a file that is named at `place`. `kind` is what messages call it ("mesh"). Why it cannot be read is
/// reported.
[[nodiscard]] std::optional<TextFile> read_asset(const Files &files, const std::filesystem::path &file,
                                                 std::string_view kind, uint64_t max_bytes, const Place &place,
                                                 Problems &problems);

/// The file's one name without symbolic links; `file` itself where the system does not tell.
[[nodiscard]] std::filesystem::path real_path(const Files &files, const std::filesystem::path &file);

} // namespace glint
