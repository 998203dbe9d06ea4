// The part of reading an OBJ file with its materials that starts from a text in memory.
#pragma once

#include <filesystem>

#include <glint/read.hpp>

#include "mesh/texture_library.hpp"
#include "text/asset_paths.hpp"
#include "text/text_file.hpp"

namespace glint {

/// As read_model(), from a text that was read already from `file`. `paths` are those of that file. Textures come from
/// `textures`, and are not among the result's files. May throw std::bad_alloc and std::filesystem::filesystem_error.
[[nodiscard]] Result<ModelFile> read_model_text(TextFile text, const std::filesystem::path &file,
                                                const AssetPaths &paths, const ReadOptions &options,
                                                TextureLibrary &textures);

} // namespace glint
