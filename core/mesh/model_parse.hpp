// Reading a checked OBJ text with all that its shading needs, through tinyobjloader.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glint/scene.hpp>

#include "mesh/obj_check.hpp"

namespace glint {

/// What a face has at one of its corners: indices from 0, or no_corner.
struct FaceCorner {
    uint32_t position = no_corner, normal = no_corner, texcoord = no_corner;
};

/// The faces of an OBJ file as they stand there, with their materials' names.
struct ModelFaces {
    struct Face {
        uint32_t corner_count;
        uint32_t material; ///< into materials
    };

    Mesh elements;                   ///< the file's positions, normals and texture coordinates; no triangles
    std::vector<FaceCorner> corners; ///< face after face
    std::vector<Face> faces;
    std::vector<std::string> materials; ///< in the order of their first faces; "" where no `usemtl` came before
};

/// The faces in a text that check_obj() passed without an error, with names. `text` is only read. Normals are left
/// aside unless wanted. May throw std::bad_alloc.
[[nodiscard]] ModelFaces parse_model(std::span<char> text, const ObjCounts &counts, bool wants_normals);

} // namespace glint
