// Flattens a scene's meshes into the two arrays that tracing reads.
#include "accel/triangle_data.hpp"

#include <cmath>

#include "scene/triangle_area.hpp"
#include "threads/parallel_for.hpp"

namespace glint {

TriangleData TriangleData::from(const Scene &scene, const Crew &crew) {
    constexpr size_t piece_size = 16384;
    TriangleData data;
    data.corners.resize(scene.triangle_count());
    data.surfaces.resize(scene.triangle_count() + scene.quadric_surfaces().size());
    size_t first_id = 0;
    for (uint32_t s = 0; s < scene.surface_count(); ++s) {
        const Mesh *const of_surface = scene.surface_mesh(s);
        if (!of_surface) continue;
        const Mesh &mesh = *of_surface;
        parallel_for_pieces(mesh.triangles.size(), piece_size, crew, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const Triangle &t = mesh.triangles[i];
                data.corners[first_id + i] = {mesh.positions[t.a], mesh.positions[t.b], mesh.positions[t.c]};
                const glm::dvec3 n = doubled_area_normal(mesh, t);
                const double length = std::sqrt((n.x * n.x + n.y * n.y) + n.z * n.z);
                data.surfaces[first_id + i] = {glm::vec3(n / length), s};
            }
        });
        first_id += mesh.triangles.size();
    }
    for (const uint32_t s : scene.quadric_surfaces()) data.surfaces[first_id++] = {glm::vec3(0.0f), s};
    return data;
}

} // namespace glint
