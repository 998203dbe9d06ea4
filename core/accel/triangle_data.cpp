// Flattens a scene's meshes into the two arrays that tracing reads.
#include "accel/triangle_data.hpp"

#include <cmath>

#include "scene/triangle_area.hpp"

namespace glint {

TriangleData TriangleData::from(const Scene &scene) {
    TriangleData data;
    data.corners.reserve(scene.triangle_count());
    data.surfaces.reserve(scene.triangle_count());
    for (uint32_t s = 0; s < scene.surface_count(); ++s) {
        const Mesh &mesh = scene.surface_mesh(s);
        for (const Triangle &t : mesh.triangles) {
            data.corners.push_back({mesh.positions[t.a], mesh.positions[t.b], mesh.positions[t.c]});
            const glm::dvec3 n = doubled_area_normal(mesh, t);
            const double length = std::sqrt((n.x * n.x + n.y * n.y) + n.z * n.z);
            data.surfaces.push_back({glm::vec3(n / length), s});
        }
    }
    return data;
}

} // namespace glint
