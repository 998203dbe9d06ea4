// From the faces of an OBJ file to a mesh for each material.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mesh/model_parse.hpp"

namespace glint {

/// The faces of one material.
struct PartMesh {
    uint32_t material; ///< into ModelFaces::materials
    std::shared_ptr<const Mesh> mesh;
};

/// The parts that have a triangle with area.
struct PartMeshes {
    std::vector<PartMesh> parts; ///< in the order of their first faces
    uint64_t triangles = 0;      ///< of all faces
    uint64_t left_out = 0;       ///< of them: without area
    uint64_t zero_normals = 0;   ///< in the file
};

/// Cuts polygons into triangles and gathers those of each material, in the file's order, with the elements that they
/// use, in the file's order too. A triangle with a corner that has no normal, or a zero one, has no normals; likewise
/// texture coordinates. All indices must be in range.
[[nodiscard]] PartMeshes make_parts(const ModelFaces &model);

} // namespace glint
