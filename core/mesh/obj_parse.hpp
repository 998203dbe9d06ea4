// Reading a checked OBJ text into a mesh, through tinyobjloader.
#pragma once

#include <span>

#include <glint/scene.hpp>

#include "mesh/obj_check.hpp"

namespace glint {

/// The mesh in a text that check_obj() passed without an error. `text` is only read. Polygons are cut into triangles,
/// in the file's order; triangles without area are still among them. May throw std::bad_alloc.
[[nodiscard]] Mesh parse_obj(std::span<char> text, const ObjCounts &counts);

} // namespace glint
