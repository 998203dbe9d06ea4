// Interpolates normals and texture coordinates over a triangle, and looks the texture up.
#include "kernel/surface_detail.hpp"

#include <cmath>

#include "math/rigid.hpp"

namespace glint {

namespace {

/// Weights of a triangle's corners.
struct Weights {
    float a, b, c;
};

/// Of the point of the triangle that is nearest along its normal's main axis: areas of the triangle's shadow on the
/// plane across that axis, in double.
Weights weights_at(const TriangleCorners &corners, const glm::vec3 &point, const glm::vec3 &facet) {
    const float x = std::abs(facet.x), y = std::abs(facet.y), z = std::abs(facet.z);
    const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    const int i = axis == 2 ? 0 : axis + 1, j = i == 2 ? 0 : i + 1;
    const auto area = [&](const glm::vec3 &p, const glm::vec3 &q, const glm::vec3 &r) {
        const double pi = component(p, i), pj = component(p, j);
        return (component(q, i) - pi) * (component(r, j) - pj) - (component(q, j) - pj) * (component(r, i) - pi);
    };
    const double all = area(corners.a, corners.b, corners.c);
    if (all == 0.0) return {1.0f, 0.0f, 0.0f};
    const auto share = [&](double part) {
        const auto weight = static_cast<float>(part / all);
        return weight > 0.0f ? (weight < 1.0f ? weight : 1.0f) : 0.0f; // rounding leaves the triangle by a little
    };
    return {share(area(point, corners.b, corners.c)), share(area(corners.a, point, corners.c)),
            share(area(corners.a, corners.b, point))};
}

/// The interpolated normal, on the viewer's side of the triangle. Where the triangle mirrors or lets through, a normal
/// that sends mirrored rays into the surface gives way to the triangle's own.
glm::vec3 shading_normal(const TriangleDetail &detail, const Weights &w, const glm::vec3 &dir, const glm::vec3 &facet,
                         bool sends_rays) {
    const glm::vec3 *const n = detail.normals;
    const glm::vec3 sum = {(n[0].x * w.a + n[1].x * w.b) + n[2].x * w.c, (n[0].y * w.a + n[1].y * w.b) + n[2].y * w.c,
                           (n[0].z * w.a + n[1].z * w.b) + n[2].z * w.c};
    if (!(dot(sum, sum) > 1e-12f)) return facet;
    glm::vec3 normal = normalize(sum);
    if (dot(normal, facet) < 0.0f) normal = -normal;
    const float n_d = dot(normal, dir);
    if (sends_rays && !(dot(dir, facet) - 2.0f * n_d * dot(normal, facet) > 0.0f && n_d < 0.0f)) return facet;
    return normal;
}

/// The number's place in [0, 1), periodically.
float wrapped(float x) {
    const float rest = x - std::floor(x);
    return rest < 1.0f ? rest : 0.0f;
}

/// Bilinear interpolation between the four nearest texels' middles; both directions repeat.
Color texel_at(const Texture &texture, float u, float v) {
    const float x = wrapped(u) * static_cast<float>(texture.width_px) - 0.5f;
    const float y = wrapped(1.0f - v) * static_cast<float>(texture.height_px) - 0.5f;
    const float x0 = std::floor(x), y0 = std::floor(y);
    const float right = x - x0, lower = y - y0;
    const auto index = [](float i, uint32_t count) {
        // -1 is the last one, `count` the first.
        return i < 0.0f ? count - 1 : static_cast<uint32_t>(i) < count ? static_cast<uint32_t>(i) : 0u;
    };
    const uint32_t columns[2] = {index(x0, texture.width_px), index(x0 + 1.0f, texture.width_px)};
    const uint32_t rows[2] = {index(y0, texture.height_px), index(y0 + 1.0f, texture.height_px)};
    const auto row = [&](uint32_t r) {
        const Color *const line = texture.texels.data() + size_t{r} * texture.width_px;
        const Color &a = line[columns[0]], &b = line[columns[1]];
        return Color(a.x + (b.x - a.x) * right, a.y + (b.y - a.y) * right, a.z + (b.z - a.z) * right);
    };
    const Color top = row(rows[0]), bottom = row(rows[1]);
    return {top.x + (bottom.x - top.x) * lower, top.y + (bottom.y - top.y) * lower, top.z + (bottom.z - top.z) * lower};
}

SurfaceDetail detail_of_mesh(const SurfaceShading &surface, uint32_t triangle_id, const glm::vec3 &point,
                             const glm::vec3 &dir, const glm::vec3 &facet) {
    SurfaceDetail result{facet, Color(1.0f)};
    if (!surface.details) return result;
    const TriangleDetail &detail = surface.details[triangle_id - surface.first_triangle];
    const Weights w = weights_at(detail.corners, point, facet);
    const bool sends_rays = surface.reflection > 0.0f || surface.transmission > 0.0f;
    if (surface.is_smooth) result.normal = shading_normal(detail, w, dir, facet, sends_rays);
    if (surface.texture) {
        const glm::vec2 *const t = detail.texcoords;
        result.tint = texel_at(*surface.texture, (t[0].x * w.a + t[1].x * w.b) + t[2].x * w.c,
                               (t[0].y * w.a + t[1].y * w.b) + t[2].y * w.c);
    }
    return result;
}

} // namespace

SurfaceDetail surface_detail(const KernelScene &scene, uint32_t surface, uint32_t triangle_id, const glm::vec3 &point,
                             const glm::vec3 &dir, const glm::vec3 &facet) {
    const SurfaceShading &shading = scene.surfaces[surface];
    const Instance *const instance = scene.geometry.instances.by_surface(surface);
    if (!instance) return detail_of_mesh(shading, triangle_id, point, dir, facet);
    const RigidTransform &pose = instance->pose;
    SurfaceDetail detail = detail_of_mesh(shading, triangle_id, point_to_object(pose, point),
                                          vector_to_object(pose, dir), vector_to_object(pose, facet));
    detail.normal = vector_to_world(pose, detail.normal);
    return detail;
}

} // namespace glint
