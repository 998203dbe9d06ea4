// From the faces of an OBJ file to a mesh for each material.
#include "mesh/model_parts.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "mesh/polygon.hpp"
#include "scene/triangle_area.hpp"

namespace glint {

namespace {

using TriangleCorners = std::array<FaceCorner, 3>;

/// New numbers, from 0 on, for those elements of a file that a part uses.
class Renumbering {
public:
    explicit Renumbering(size_t count) : numbers_(count, no_corner) {}

    void use(uint32_t element) {
        if (numbers_[element] != no_corner) return;
        numbers_[element] = 0;
        used_.push_back(element);
    }
    void use(uint32_t a, uint32_t b, uint32_t c) { use(a), use(b), use(c); }

    /// Gives out the numbers, in the order of the file.
    void number() {
        if (!std::is_sorted(used_.begin(), used_.end())) std::sort(used_.begin(), used_.end());
        for (size_t i = 0; i < used_.size(); ++i) numbers_[used_[i]] = static_cast<uint32_t>(i);
    }

    [[nodiscard]] Triangle of(uint32_t a, uint32_t b, uint32_t c) const {
        return {numbers_[a], numbers_[b], numbers_[c]};
    }

    template <typename Element> [[nodiscard]] std::vector<Element> pick(const std::vector<Element> &all) const {
        std::vector<Element> picked;
        picked.reserve(used_.size());
        for (const uint32_t element : used_) picked.push_back(all[element]);
        return picked;
    }

    /// Takes time only for what was used: a file may have very many parts.
    void clear() {
        for (const uint32_t element : used_) numbers_[element] = no_corner;
        used_.clear();
    }

private:
    std::vector<uint32_t> numbers_; ///< by element; no_corner where it is not used
    std::vector<uint32_t> used_;
};

class PartMaker {
public:
    explicit PartMaker(const ModelFaces &model)
        : model_(model),
          positions_(model.elements.positions.size()),
          normals_(model.elements.normals.size()),
          texcoords_(model.elements.texcoords.size()) {}

    PartMeshes run() {
        const auto is_zero = [](const Vector &n) { return n.x == 0.0f && n.y == 0.0f && n.z == 0.0f; };
        zero_normals_.resize(model_.elements.normals.size());
        std::transform(model_.elements.normals.begin(), model_.elements.normals.end(), zero_normals_.begin(), is_zero);
        result_.zero_normals = static_cast<uint64_t>(std::count(zero_normals_.begin(), zero_normals_.end(), 1));

        sort_faces();
        for (uint32_t material = 0; material < model_.materials.size(); ++material) {
            triangles_.clear();
            for (size_t i = first_face_[material]; i < first_face_[material + 1]; ++i) add_face(faces_[i]);
            if (!triangles_.empty()) result_.parts.push_back({material, std::make_shared<const Mesh>(take_mesh())});
        }
        return std::move(result_);
    }

private:
    /// Puts the numbers of the faces of each material side by side.
    void sort_faces() {
        first_face_.assign(model_.materials.size() + 1, 0);
        for (const ModelFaces::Face &face : model_.faces) ++first_face_[face.material + 1];
        std::partial_sum(first_face_.begin(), first_face_.end(), first_face_.begin());
        faces_.resize(model_.faces.size());
        std::vector<size_t> next(first_face_);
        size_t corner = 0;
        for (const ModelFaces::Face &face : model_.faces) {
            faces_[next[face.material]++] = {corner, face.corner_count};
            corner += face.corner_count;
        }
    }

    struct FaceCorners {
        size_t first;
        uint32_t count;
    };

    void add_face(const FaceCorners &face) {
        const FaceCorner *const corners = &model_.corners[face.first];
        result_.triangles += face.count - 2;
        if (face.count == 3) return add_triangle(corners[0], corners[1], corners[2]);
        // The cutter is to tell corners apart, not positions: a polygon may come by a position twice, with another
        // normal.
        own_positions_.clear();
        for (uint32_t i = 0; i < face.count; ++i) {
            own_positions_.push_back(model_.elements.positions[corners[i].position]);
        }
        for (auto i = static_cast<uint32_t>(own_corners_.size()); i < face.count; ++i) own_corners_.push_back(i);
        cut_.resize(face.count - 2);
        cutter_.cut({own_corners_.data(), face.count}, own_positions_, cut_.data());
        for (const Triangle &t : cut_) add_triangle(corners[t.a], corners[t.b], corners[t.c]);
    }

    void add_triangle(const FaceCorner &a, const FaceCorner &b, const FaceCorner &c) {
        if (has_area(model_.elements, {a.position, b.position, c.position})) {
            triangles_.push_back({a, b, c});
        } else {
            ++result_.left_out;
        }
    }

    [[nodiscard]] bool has_normal(const FaceCorner &corner) const {
        return corner.normal != no_corner && !zero_normals_[corner.normal];
    }
    [[nodiscard]] bool has_normals(const TriangleCorners &t) const {
        return has_normal(t[0]) && has_normal(t[1]) && has_normal(t[2]);
    }
    [[nodiscard]] static bool has_texcoords(const TriangleCorners &t) {
        return t[0].texcoord != no_corner && t[1].texcoord != no_corner && t[2].texcoord != no_corner;
    }

    Mesh take_mesh() {
        bool any_normals = false, any_texcoords = false;
        for (const TriangleCorners &t : triangles_) {
            positions_.use(t[0].position, t[1].position, t[2].position);
            if (has_normals(t)) normals_.use(t[0].normal, t[1].normal, t[2].normal), any_normals = true;
            if (has_texcoords(t)) texcoords_.use(t[0].texcoord, t[1].texcoord, t[2].texcoord), any_texcoords = true;
        }
        positions_.number();
        normals_.number();
        texcoords_.number();

        Mesh mesh;
        constexpr Triangle none{no_corner, no_corner, no_corner};
        mesh.triangles.reserve(triangles_.size());
        if (any_normals) mesh.normal_corners.reserve(triangles_.size());
        if (any_texcoords) mesh.texcoord_corners.reserve(triangles_.size());
        for (const TriangleCorners &t : triangles_) {
            mesh.triangles.push_back(positions_.of(t[0].position, t[1].position, t[2].position));
            if (any_normals) {
                mesh.normal_corners.push_back(has_normals(t) ? normals_.of(t[0].normal, t[1].normal, t[2].normal)
                                                             : none);
            }
            if (any_texcoords) {
                mesh.texcoord_corners.push_back(
                    has_texcoords(t) ? texcoords_.of(t[0].texcoord, t[1].texcoord, t[2].texcoord) : none);
            }
        }
        mesh.positions = positions_.pick(model_.elements.positions);
        mesh.normals = normals_.pick(model_.elements.normals);
        mesh.texcoords = texcoords_.pick(model_.elements.texcoords);
        positions_.clear();
        normals_.clear();
        texcoords_.clear();
        return mesh;
    }

    const ModelFaces &model_;
    PartMeshes result_;
    std::vector<uint8_t> zero_normals_; ///< by normal
    std::vector<size_t> first_face_;    ///< by material, into faces_; one more at the end
    std::vector<FaceCorners> faces_;    ///< material after material

    // Of one polygon.
    PolygonCutter cutter_;
    std::vector<Point> own_positions_;
    std::vector<uint32_t> own_corners_; ///< 0, 1, 2, ...
    std::vector<Triangle> cut_;

    // Of one part.
    std::vector<TriangleCorners> triangles_;
    Renumbering positions_, normals_, texcoords_;
};

} // namespace

PartMeshes make_parts(const ModelFaces &model) {
    return PartMaker(model).run();
}

} // namespace glint
