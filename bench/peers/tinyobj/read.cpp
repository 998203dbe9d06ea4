// tinyobjloader by itself.
#include "bench/peers/tinyobj/read.hpp"

#define TINYOBJLOADER_IMPLEMENTATION
#define tinyobj glint_bench_tinyobj // the core has its own
#include <tiny_obj_loader.h>

namespace glint::bench {

Result<TinyobjMesh> read_with_tinyobj(const std::filesystem::path &file) {
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(file.string())) {
        return Error(ErrorCode::bad_input, file.string() + ": tinyobjloader says: " + reader.Error());
    }
    TinyobjMesh mesh;
    mesh.positions = reader.GetAttrib().vertices.size() / 3;
    for (const tinyobj::shape_t &shape : reader.GetShapes()) mesh.triangles += shape.mesh.num_face_vertices.size();
    return mesh;
}

} // namespace glint::bench
