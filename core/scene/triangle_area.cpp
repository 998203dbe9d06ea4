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
