// Reading a checked OBJ text into a mesh, through tinyobjloader.
#include "mesh/obj_parse.hpp"

#include <istream>
#include <vector>

#include "mesh/polygon.hpp"

#define TINYOBJLOADER_IMPLEMENTATION // here, and nowhere else
#include "mesh/tinyobj.hpp"

namespace glint {

namespace {

/// Takes vertices and faces from tinyobjloader as it meets them: its other interface keeps a vector for each face, ten
/// times the memory, and cuts concave quadrilaterals along the wrong diagonal.
class MeshMaker {
public:
    explicit MeshMaker(const ObjCounts &counts) {
        mesh_.positions.reserve(static_cast<size_t>(counts.vertices));
        mesh_.triangles.reserve(static_cast<size_t>(counts.triangles));
    }

    void add_vertex(float x, float y, float z) { mesh_.positions.emplace_back(x, y, z); }

    void add_face(const tinyobj::index_t *corners, int count) {
        corners_.clear();
        bool all_known = true;
        for (int i = 0; i < count; ++i) {
            const int index = corners[i].vertex_index;
            corners_.push_back(index > 0
                                   ? static_cast<uint32_t>(index - 1)
                                   : static_cast<uint32_t>(mesh_.positions.size()) - static_cast<uint32_t>(-index));
            all_known = all_known && corners_.back() < mesh_.positions.size();
        }
        if (count == 3) {
            mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
            return;
        }
        const size_t first = mesh_.triangles.size();
        mesh_.triangles.resize(first + corners_.size() - 2);
        if (all_known) {
            cutter_.cut(corners_, mesh_.positions, &mesh_.triangles[first]);
        } else {
            early_polygons_.push_back({first, corners_});
        }
    }

    /// Call once all vertices are there.
    Mesh take_mesh() {
        for (const EarlyPolygon &polygon : early_polygons_) {
            cutter_.cut(polygon.corners, mesh_.positions, &mesh_.triangles[polygon.first_triangle]);
        }
        return std::move(mesh_);
    }

private:
    /// A polygon that stands in the file before one of its vertices; how to cut it shows only at the end.
    struct EarlyPolygon {
        size_t first_triangle;
        std::vector<uint32_t> corners;
    };

    Mesh mesh_;
    PolygonCutter cutter_;
    std::vector<uint32_t> corners_;
    std::vector<EarlyPolygon> early_polygons_;
};

} // namespace

Mesh parse_obj(std::span<char> text, const ObjCounts &counts) {
    MeshMaker maker(counts);
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void *user, float x, float y, float z, float) {
        static_cast<MeshMaker *>(user)->add_vertex(x, y, z);
    };
    callbacks.index_cb = [](void *user, tinyobj::index_t *corners, int count) {
        static_cast<MeshMaker *>(user)->add_face(corners, count);
    };
    TextStream buffer(text);
    std::istream stream(&buffer);
    // No material reader: MTL files are never opened.
    tinyobj::LoadObjWithCallback(stream, callbacks, &maker, nullptr, nullptr, nullptr);
    return maker.take_mesh();
}

} // namespace glint
