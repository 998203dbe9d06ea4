// Meshes and quadrics as directives name them.
#include "sdl/read_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "scene/quadric_shape.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// Coefficients as they stand in the file.
struct Coefficients {
    float a, b, c, d, e, f, g, h, j, k;
};

Coefficients read_coefficients(const Arguments &arguments, size_t i) {
    const auto number = [&](size_t n) { return arguments.number(i + n, -max_coordinate, max_coordinate); };
    return {number(0), number(1), number(2), number(3), number(4),
            number(5), number(6), number(7), number(8), number(9)};
}

Quadric checked(const Arguments &arguments, size_t i, const Quadric &q) {
    const float sum = q.a + q.b + q.c + q.d + q.e + q.f + q.g + q.h + q.j + q.k;
    if (std::isnan(sum)) return q; // told already
    if (auto problem = quadric_problem(q)) arguments.error(i, std::move(*problem));
    return q;
}

/// Reports the first mesh that passes the limit of the whole scene; false from there on.
[[nodiscard]] bool count_triangles(const Arguments &arguments, size_t i, SceneDraft &draft, uint64_t count) {
    const uint64_t limit = std::min(draft.options.limits.max_triangles, uint64_t{1} << 30);
    const bool was_within = draft.triangle_count <= limit;
    draft.triangle_count += count;
    if (was_within && draft.triangle_count > limit) {
        arguments.error(
            i, words("with this mesh the scene has ", draft.triangle_count, " triangles, the limit is ", limit), {},
            ErrorCode::limit_exceeded);
    }
    return draft.triangle_count <= limit;
}

} // namespace

std::shared_ptr<const Mesh> read_mesh(const Arguments &arguments, size_t i, SceneDraft &draft, const Vector &offset,
                                      std::filesystem::path *file) {
    MeshLibrary::Found found = draft.meshes.find(arguments.word(i), arguments.place(i), arguments.problems());
    if (!found.mesh) return nullptr;
    *file = std::move(found.file);
    if (!count_triangles(arguments, i, draft, found.mesh->triangles.size())) return nullptr; // before it is copied
    return draft.meshes.moved(found.mesh, offset, arguments.word(i), arguments.place(i), arguments.problems());
}

ObjectDraft read_model(const Arguments &arguments, size_t i, SceneDraft &draft) {
    ObjectDraft entry;
    entry.from_mtl = true;
    const MeshLibrary::FoundModel found =
        draft.meshes.find_model(arguments.word(i), arguments.place(i), arguments.problems());
    if (!found.model) return entry;
    entry.file = found.file;
    uint64_t triangles = 0;
    for (const ModelPart &part : found.model->parts) {
        Object object;
        object.name = std::string(arguments.word(i));
        if (!part.material_name.empty()) object.name += ':' + part.material_name;
        object.mesh = part.mesh;
        object.material = part.material;
        triangles += part.mesh->triangles.size();
        entry.parts.push_back(std::move(object));
    }
    if (!count_triangles(arguments, i, draft, triangles)) entry.parts.clear();
    return entry;
}

Quadric read_quadric(const Arguments &arguments, size_t i) {
    const Coefficients c = read_coefficients(arguments, i);
    return checked(arguments, i, {c.a, c.b, c.c, c.d, c.e, c.f, c.g, c.h, c.j, c.k});
}

Quadric read_cg_quadric_coefficients(const Arguments &arguments, size_t i) {
    const Coefficients c = read_coefficients(arguments, i);
    // Halves are exact, but of the very smallest numbers.
    return checked(arguments, i,
                   {c.a, c.b, c.c, 0.5f * c.d, 0.5f * c.f, 0.5f * c.e, 0.5f * c.g, 0.5f * c.h, 0.5f * c.j, c.k});
}

} // namespace glint
