// Writing meshes as Wavefront OBJ text, small and the same to the byte everywhere.
#pragma once

#include <filesystem>

#include "generate/mesh.hpp"

namespace glint::scenes {

/// The whole text of the file: the comment, `v` lines with at most five decimals, `f` lines.
[[nodiscard]] std::string obj_text(const NamedMesh &named);

/// Writes obj_text() to folder/file_name, through a temporary file beside it that is renamed at the end: a program that
/// reads the folder meanwhile sees the old file or the new one, never half of one. Throws std::system_error.
void write_obj(const NamedMesh &named, const std::filesystem::path &folder);

} // namespace glint::scenes
