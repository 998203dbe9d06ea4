// What shading knows about a hit.
#pragma once

#include <glm/vec3.hpp>

#include "kernel/kernel.hpp"
#include "kernel/surface_detail.hpp"
#include "math/vec.hpp"

namespace glint {

/// Surface points lie within 3 * 2^-24 of the surface, times the largest length that was rounded on the way to them;
/// moving them five times that along the normal puts them on the viewer's side for certain.
inline constexpr float offset_of_scale = 0x1p-20f;

/// Shadow rays run from the light to the offset point, at t = 1. The direction's rounding may end the ray a few ulps
/// beyond it.
inline constexpr float shadow_t_max = 1.0f - 0x1p-22f;

struct SurfacePoint {
    glm::vec3 position;
    glm::vec3 facet;  ///< the surface's own normal; faces the viewer
    glm::vec3 normal; ///< for shading: the same, or interpolated between a triangle's corners
    float scale;      ///< the largest length that was rounded on the way to the position
    Color tint;       ///< from the surface's texture
    const SurfaceShading *surface;
    uint32_t surface_number;
    uint32_t left; ///< the flat triangle it lies on, which no ray from here meets again; no_triangle on a quadric
};

inline float larger(float a, float b) {
    return a > b ? a : b;
}

inline SurfacePoint surface_point(const KernelScene &scene, const PreparedRay &ray, const Hit &hit) {
    const TriangleSurface &triangle = scene.geometry.surfaces[hit.triangle_id];
    const glm::vec3 way = {hit.t * ray.dir.x, hit.t * ray.dir.y, hit.t * ray.dir.z};
    SurfacePoint point;
    point.position = {ray.org.x + way.x, ray.org.y + way.y, ray.org.z + way.z};
    point.scale = larger(larger(max_abs(point.position), max_abs(way)), scene.offset_floor);
    const bool is_quadric = hit.triangle_id >= scene.geometry.triangle_count;
    const Instance *const instance = scene.geometry.instances.by_surface(triangle.surface);
    if (instance) point.scale = larger(point.scale, instance->least_length) * instance->length_factor;
    const glm::vec3 normal =
        is_quadric ? quadric_normal(scene.geometry.quadrics.by_number(hit.triangle_id - scene.geometry.triangle_count),
                                    point.position, ray.dir)
        : instance ? vector_to_world(instance->pose, triangle.normal)
                   : triangle.normal;
    point.facet = dot(normal, ray.dir) > 0.0f ? -normal : normal;
    point.normal = point.facet;
    point.tint = Color(1.0f);
    point.surface_number = triangle.surface;
    point.surface = &scene.surfaces[triangle.surface];
    point.left = is_quadric ? no_triangle : hit.triangle_id;
    if (!is_quadric && point.surface->details) {
        const SurfaceDetail detail =
            surface_detail(scene, point.surface_number, hit.triangle_id, point.position, ray.dir, point.facet);
        point.normal = detail.normal;
        point.tint = detail.tint;
    }
    return point;
}

/// The point moved off its surface along the normal.
inline glm::vec3 offset_point(const SurfacePoint &point, float scale, float side) {
    const float offset = side * (offset_of_scale * scale);
    return {point.position.x + point.facet.x * offset, point.position.y + point.facet.y * offset,
            point.position.z + point.facet.z * offset};
}

} // namespace glint
