// tinyobjloader by itself: what reading a mesh costs without the checks that Glint puts before it.
#pragma once

#include <cstddef>
#include <filesystem>

#include <glint/result.hpp>

namespace glint::bench {

/// What an OBJ file holds, as tinyobj::ObjReader reads and triangulates it.
struct TinyobjMesh {
    size_t positions = 0;
    size_t triangles = 0;
};
[[nodiscard]] Result<TinyobjMesh> read_with_tinyobj(const std::filesystem::path &file);

} // namespace glint::bench
