// Whitted ray tracing, one ray at a time: the definition of the picture. Read this first.
//
//     local  = ka Ia C + sum over lights that the shadow ray reaches of L (kd C max(0, N.L) + ks max(0, R.V)^ke)
//     colour = (1 - kr - kt) local + kr reflected + kt transmitted    while the depth allows
//     colour = local                                                  at the depth limit
//
// (Whitted 1980, "An improved illumination model for shaded display"; Phong 1975 for the highlight.) The recursion is
// unrolled: each ray carries its weight in the pixel, each hit adds weight * share * local. A pixel's terms are added
// along the mirror rays first, transmitted rays after them, the last one met first.
#include <limits>

#include "image/resolve.hpp"
#include "kernel/kernel.hpp"
#include "math/pow.hpp"

namespace glint {

namespace {

/// Where a hit goes both ways, mirrored and transmitted, the way of less weight in the pixel than this is not taken and
/// its share stays with the local colour: below a sixteenth of an 8-bit step. It keeps the ray tree of a scene with
/// many such surfaces finite in practice; since weights add up to 1 at most, no more than 4096 rays ever wait.
constexpr float least_branch_weight = 1.0f / 4096.0f;

/// Surface points lie within 3 * 2^-24 of the surface, times the largest length that was rounded on the way to them;
/// moving them five times that along the normal puts them on the viewer's side for certain.
constexpr float offset_of_scale = 0x1p-20f;

/// Shadow rays run from the light to the offset point, at t = 1. The direction's rounding may end the ray a few ulps
/// beyond it.
constexpr float shadow_t_max = 1.0f - 0x1p-22f;

/// What shading knows about a hit.
struct SurfacePoint {
    glm::vec3 position;
    glm::vec3 normal; ///< faces the viewer
    float scale;      ///< the largest length that was rounded on the way to the position
    const SurfaceShading *surface;
    uint32_t triangle_id;
};

float larger(float a, float b) {
    return a > b ? a : b;
}

SurfacePoint surface_point(const KernelScene &scene, const PreparedRay &ray, const Hit &hit) {
    const TriangleSurface &triangle = scene.geometry.surfaces[hit.triangle_id];
    const glm::vec3 way = {hit.t * ray.dir.x, hit.t * ray.dir.y, hit.t * ray.dir.z};
    SurfacePoint point;
    point.position = {ray.org.x + way.x, ray.org.y + way.y, ray.org.z + way.z};
    point.scale = larger(larger(max_abs(point.position), max_abs(way)), scene.offset_floor);
    point.normal = dot(triangle.normal, ray.dir) > 0.0f ? -triangle.normal : triangle.normal;
    point.surface = &scene.surfaces[triangle.surface];
    point.triangle_id = hit.triangle_id;
    return point;
}

/// The point moved off its surface along the normal.
glm::vec3 offset_point(const SurfacePoint &point, float scale, float side) {
    const float offset = side * (offset_of_scale * scale);
    return {point.position.x + point.normal.x * offset, point.position.y + point.normal.y * offset,
            point.position.z + point.normal.z * offset};
}

bool light_reaches(const KernelScene &scene, const LightShading &light, const SurfacePoint &point) {
    const float distance = max_abs(light.position - point.position);
    const glm::vec3 end = offset_point(point, larger(distance, point.scale), 1.0f);
    const Ray ray{light.position, end - light.position};
    const auto can_block = [&](uint32_t triangle_id) {
        return triangle_id != point.triangle_id && triangle_id - light.first_triangle >= light.triangle_count;
    };
    return !any_hit(scene.geometry, PreparedRay(ray, scene.geometry.bounds), shadow_t_max, can_block);
}

/// Ambient, diffuse and specular light at a point; `to_viewer` is a unit vector.
Color local_color(const KernelScene &scene, const SurfacePoint &point, const glm::vec3 &to_viewer, RayCounts &rays) {
    const SurfaceShading &surface = *point.surface;
    Color color = surface.ambient_color;
    for (uint32_t i = 0; i < scene.light_count; ++i) {
        const LightShading &light = scene.lights[i];
        const glm::vec3 delta = light.position - point.position;
        // A light behind the surface, as the viewer sees it, is hidden by the surface itself.
        if (!(dot(point.normal, delta) > 0.0f)) continue;
        ++rays.shadow;
        if (!light_reaches(scene, light, point)) continue;
        const glm::vec3 to_light = normalize(delta);
        const float n_l = dot(point.normal, to_light);
        float highlight = 0.0f;
        if (surface.specular > 0.0f) {
            // R.V with R = 2 (N.L) N - L.
            const float r_v = (2.0f * n_l) * dot(point.normal, to_viewer) - dot(to_light, to_viewer);
            highlight = surface.specular * pow_unit(r_v > 0.0f ? r_v : 0.0f, surface.exponent);
        }
        color.x += light.emission.x * (surface.diffuse_color.x * n_l + highlight);
        color.y += light.emission.y * (surface.diffuse_color.y * n_l + highlight);
        color.z += light.emission.z * (surface.diffuse_color.z * n_l + highlight);
    }
    return color;
}

void add_weighted(Color &sum, float weight, const Color &color) {
    sum.x += weight * color.x;
    sum.y += weight * color.y;
    sum.z += weight * color.z;
}

/// The colour that arrives along a primary ray.
Color trace(const KernelScene &scene, const Ray &primary, uint32_t max_depth, KernelScratch &scratch) {
    Color color(0.0f);
    scratch.pending.clear();
    PendingRay next{primary, 0, 1.0f, no_triangle};
    const auto another_ray = [&] {
        if (scratch.pending.empty()) return false;
        next = scratch.pending.back();
        scratch.pending.pop_back();
        return true;
    };
    do {
        const PreparedRay ray(next.ray, scene.geometry.bounds);
        const Hit hit = closest_hit(scene.geometry, ray, std::numeric_limits<float>::max(), next.left_triangle);
        if (hit.triangle_id == no_triangle) {
            add_weighted(color, next.weight, scene.background);
            continue;
        }
        const SurfacePoint point = surface_point(scene, ray, hit);
        const SurfaceShading &surface = *point.surface;
        if (surface.is_light) {
            add_weighted(color, next.weight, surface.emission);
            continue;
        }

        const bool deeper = next.depth < max_depth;
        float reflection = deeper ? surface.reflection : 0.0f;
        float transmission = deeper ? surface.transmission : 0.0f;
        if (reflection > 0.0f && transmission > 0.0f) {
            if (next.weight * reflection < least_branch_weight) reflection = 0.0f;
            if (next.weight * transmission < least_branch_weight) transmission = 0.0f;
        }
        const float local_share = (1.0f - reflection) - transmission;
        if (local_share > 0.0f) {
            add_weighted(color, next.weight * local_share, local_color(scene, point, -ray.dir, scratch.rays));
        }
        if (transmission > 0.0f) {
            // Without an index of refraction in this dialect, light goes straight on.
            ++scratch.rays.secondary;
            scratch.pending.push_back({{offset_point(point, point.scale, -1.0f), ray.dir},
                                       next.depth + 1,
                                       next.weight * transmission,
                                       hit.triangle_id});
        }
        if (reflection > 0.0f) {
            ++scratch.rays.secondary;
            const float twice_n_d = 2.0f * dot(point.normal, ray.dir);
            const glm::vec3 mirrored = {ray.dir.x - twice_n_d * point.normal.x, ray.dir.y - twice_n_d * point.normal.y,
                                        ray.dir.z - twice_n_d * point.normal.z};
            scratch.pending.push_back({{offset_point(point, point.scale, 1.0f), normalize(mirrored)},
                                       next.depth + 1,
                                       next.weight * reflection,
                                       hit.triangle_id});
        }
    } while (another_ray());
    return color;
}

size_t scratch_bytes(const KernelScene &, const KernelFrame &) {
    return 0;
}

void render_tile(const KernelScene &scene, const KernelFrame &frame, Tile tile, KernelScratch &scratch) {
    const Camera &camera = frame.camera;
    const float inverse_width = 1.0f / static_cast<float>(frame.width_px);
    const float inverse_height = 1.0f / static_cast<float>(frame.height_px);
    const glm::vec3 eye_to_corner = camera.top_left - camera.eye;
    for (uint32_t y = tile.y0; y < tile.y1; ++y) {
        const float v = (static_cast<float>(y) + 0.5f) * inverse_height;
        for (uint32_t x = tile.x0; x < tile.x1; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) * inverse_width;
            const glm::vec3 to_pixel = {(eye_to_corner.x + camera.right.x * u) + camera.down.x * v,
                                        (eye_to_corner.y + camera.right.y * u) + camera.down.y * v,
                                        (eye_to_corner.z + camera.right.z * u) + camera.down.z * v};
            ++scratch.rays.primary;
            const Color color = trace(scene, {camera.eye, normalize(to_pixel)}, frame.max_depth, scratch);

            const size_t pixel = size_t{y} * frame.width_px + x;
            for (int channel = 0; channel < 3; ++channel) {
                frame.rgba8[pixel * 4 + channel] = resolve_channel(color[channel]);
                if (frame.radiance) frame.radiance[pixel * 3 + channel] = color[channel];
            }
            frame.rgba8[pixel * 4 + 3] = 255;
        }
    }
}

Ray ray_of(const RayBatch &rays, size_t i) {
    return {{rays.org_x[i], rays.org_y[i], rays.org_z[i]}, {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]}};
}

void closest_hits(const GeometryView &geometry, const RayBatch &rays, const HitBatch &hits) {
    for (size_t i = 0; i < rays.count; ++i) {
        const Hit hit = closest_hit(geometry, PreparedRay(ray_of(rays, i), geometry.bounds), rays.t_max[i]);
        hits.t[i] = hit.t;
        hits.triangle_id[i] = hit.triangle_id;
    }
}

void any_hits(const GeometryView &geometry, const RayBatch &rays, uint8_t *occluded) {
    const auto everything = [](uint32_t) { return true; };
    for (size_t i = 0; i < rays.count; ++i) {
        const PreparedRay ray(ray_of(rays, i), geometry.bounds);
        occluded[i] = any_hit(geometry, ray, rays.t_max[i], everything) ? 1 : 0;
    }
}

} // namespace

const Kernel scalar_kernel = {Isa::scalar, scratch_bytes, render_tile, closest_hits, any_hits};

} // namespace glint
