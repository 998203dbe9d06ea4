// Exact-enough area of a triangle.
#include "scene/triangle_area.hpp"

#include <cmath>

namespace glint {

glm::dvec3 doubled_area_normal(const Mesh &mesh, const Triangle &triangle) {
    const glm::dvec3 a(mesh.positions[triangle.a]);
    const glm::dvec3 ab = glm::dvec3(mesh.positions[triangle.b]) - a;
    const glm::dvec3 ac = glm::dvec3(mesh.positions[triangle.c]) - a;
    return {ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
}

bool has_area(const Mesh &mesh, const Triangle &triangle) {
    const glm::dvec3 n = doubled_area_normal(mesh, triangle);
    return n.x != 0.0 || n.y != 0.0 || n.z != 0.0;
}

size_t erase_triangles_without_area(Mesh &mesh) {
    const size_t all = mesh.triangles.size();
    size_t kept = 0;
    for (size_t i = 0; i < all; ++i) {
        if (!has_area(mesh, mesh.triangles[i])) continue;
        mesh.triangles[kept] = mesh.triangles[i];
        if (!mesh.normal_corners.empty()) mesh.normal_corners[kept] = mesh.normal_corners[i];
        if (!mesh.texcoord_corners.empty()) mesh.texcoord_corners[kept] = mesh.texcoord_corners[i];
        ++kept;
    }
    mesh.triangles.resize(kept);
    if (!mesh.normal_corners.empty()) mesh.normal_corners.resize(kept);
    if (!mesh.texcoord_corners.empty()) mesh.texcoord_corners.resize(kept);
    return all - kept;
}

Point area_weighted_centroid(const Mesh &mesh) {
    glm::dvec3 sum(0.0);
    double weight = 0.0;
    for (const Triangle &triangle : mesh.triangles) {
        const glm::dvec3 n = doubled_area_normal(mesh, triangle);
        const double area = std::sqrt((n.x * n.x + n.y * n.y) + n.z * n.z);
        const glm::dvec3 corners = glm::dvec3(mesh.positions[triangle.a]) + glm::dvec3(mesh.positions[triangle.b]) +
                                   glm::dvec3(mesh.positions[triangle.c]);
        sum += corners * (area / 3.0);
        weight += area;
    }
    return Point(sum / weight);
}

} // namespace glint
