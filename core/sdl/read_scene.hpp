// The parts of reading and converting scenes that start from a text in memory.
#pragma once

#include <filesystem>

#include <glint/read.hpp>

#include "text/text_file.hpp"

namespace glint {

/// As read_scene(), from a text that was read already. `file` is where it would lie: diagnostics call it so, and what
/// it names is looked for beside it.
[[nodiscard]] Result<SceneFile> read_scene_text(TextFile text, const std::filesystem::path &file,
                                                const ReadOptions &options = {});

/// As convert_scene(), likewise.
[[nodiscard]] Result<ConvertedScene> convert_scene_text(TextFile text, const std::filesystem::path &file,
                                                        const std::filesystem::path &folder,
                                                        const ReadOptions &options = {});

} // namespace glint
