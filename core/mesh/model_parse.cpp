// Reading a checked OBJ text with all that its shading needs, through tinyobjloader.
#include "mesh/model_parse.hpp"

#include <istream>
#include <unordered_map>
#include <utility>

#include "mesh/obj_lines.hpp"
#include "mesh/tinyobj.hpp"

namespace glint {

namespace {

/// Takes elements and faces from tinyobjloader as it meets them.
class FaceCollector {
public:
    FaceCollector(const ObjCounts &counts, bool wants_normals) : wants_normals_(wants_normals) {
        model_.elements.positions.reserve(static_cast<size_t>(counts.vertices));
        model_.elements.texcoords.reserve(static_cast<size_t>(counts.texcoords));
        model_.elements.normals.reserve(static_cast<size_t>(counts.normals));
        model_.corners.reserve(static_cast<size_t>(counts.triangles + 2 * counts.faces)); // n - 2 triangles, n corners
        model_.faces.reserve(static_cast<size_t>(counts.faces));
    }

    void add_position(float x, float y, float z) { model_.elements.positions.emplace_back(x, y, z); }
    void add_normal(float x, float y, float z) { model_.elements.normals.emplace_back(x, y, z); }
    void add_texcoord(float u, float v) { model_.elements.texcoords.emplace_back(u, v); }

    /// Only materials with faces get a number.
    void use_material(std::string_view name) {
        while (!name.empty() && is_blank(name.front())) name.remove_prefix(1);
        while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
        material_ = name;
        has_number_ = false;
    }

    void add_face(const tinyobj::index_t *corners, int count) {
        if (!has_number_) {
            const auto [entry, is_new] =
                numbers_.try_emplace(material_, static_cast<uint32_t>(model_.materials.size()));
            if (is_new) model_.materials.push_back(material_);
            number_ = entry->second;
            has_number_ = true;
        }
        for (int i = 0; i < count; ++i) {
            FaceCorner corner;
            corner.position = from_zero(corners[i].vertex_index, model_.elements.positions.size());
            corner.texcoord = from_zero(corners[i].texcoord_index, model_.elements.texcoords.size());
            if (wants_normals_) corner.normal = from_zero(corners[i].normal_index, model_.elements.normals.size());
            model_.corners.push_back(corner);
        }
        model_.faces.push_back({static_cast<uint32_t>(count), number_});
    }

    ModelFaces take() { return std::move(model_); }

private:
    /// tinyobjloader hands on what the file says: from 1, negative for "back from here", 0 for "none".
    static uint32_t from_zero(int index, size_t so_far) {
        if (index == 0) return no_corner;
        return index > 0 ? static_cast<uint32_t>(index - 1)
                         : static_cast<uint32_t>(so_far) - static_cast<uint32_t>(-index);
    }

    bool wants_normals_;
    ModelFaces model_;
    std::unordered_map<std::string, uint32_t> numbers_; ///< of materials, by name
    std::string material_;                              ///< of the faces that come now
    uint32_t number_ = 0;                               ///< of material_
    bool has_number_ = false;
};

} // namespace

ModelFaces parse_model(std::span<char> text, const ObjCounts &counts, bool wants_normals) {
    FaceCollector collector(counts, wants_normals);
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void *user, float x, float y, float z, float) {
        static_cast<FaceCollector *>(user)->add_position(x, y, z);
    };
    callbacks.normal_cb = [](void *user, float x, float y, float z) {
        static_cast<FaceCollector *>(user)->add_normal(x, y, z);
    };
    callbacks.texcoord_cb = [](void *user, float u, float v, float) {
        static_cast<FaceCollector *>(user)->add_texcoord(u, v);
    };
    callbacks.usemtl_cb = [](void *user, const char *name, int) {
        static_cast<FaceCollector *>(user)->use_material(name);
    };
    callbacks.index_cb = [](void *user, tinyobj::index_t *corners, int count) {
        static_cast<FaceCollector *>(user)->add_face(corners, count);
    };
    TextStream buffer(text);
    std::istream stream(&buffer);
    // No material reader: check_obj() has seen which MTL files there are.
    tinyobj::LoadObjWithCallback(stream, callbacks, &collector, nullptr, nullptr, nullptr);
    return collector.take();
}

} // namespace glint
