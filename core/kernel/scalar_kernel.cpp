// Whitted ray tracing, one ray at a time: the definition of the picture. Read this first.
//
//     local  = ka Ia C + sum over lights that the shadow ray reaches of L (kd C max(0, N.L) + ks max(0, R.V)^ke)
//     colour = (1 - kr - kt) local + kr reflected + kt transmitted    while the depth allows
//     colour = local                                                  at the depth limit
//
// where surfaces add mirrored and transmitted light: colour = local + kr reflected + kt transmitted, while the depth
// allows.
//
// (Whitted 1980, "An improved illumination model for shaded display"; Phong 1975 for the highlight.) The recursion is
// unrolled: each ray carries its weight in the pixel, each hit adds weight * share * local. A pixel's terms are added
// along the mirror rays first, transmitted rays after them, the last one met first.
#include <limits>

#include "image/resolve.hpp"
#include "image/tone_curve.hpp"
#include "kernel/incoming_light.hpp"
#include "kernel/kernel.hpp"
#include "kernel/ray_recorder.hpp"
#include "kernel/refraction.hpp"
#include "kernel/surface_point.hpp"
#include "math/pow.hpp"

namespace glint {

namespace {

/// Where a hit goes both ways, mirrored and transmitted, the way of less weight in the pixel than this is not taken and
/// its share stays with the local colour: below a sixteenth of an 8-bit step. It keeps the ray tree of a scene with
/// many such surfaces finite in practice; since weights add up to 1 at most, no more than 4096 rays ever wait.
constexpr float least_branch_weight = 1.0f / 4096.0f;

/// Ambient, diffuse and specular light at a point; `to_viewer` is a unit vector.
Color local_color(const KernelScene &scene, const SurfacePoint &point, const glm::vec3 &to_viewer, RayCounts &rays,
                  RayRecorder *recorder) {
    const SurfaceShading &surface = *point.surface;
    Color color = surface.ambient_color * point.tint;
    const Color diffuse = surface.diffuse_color * point.tint;
    for (uint32_t i = 0; i < scene.light_count; ++i) {
        const LightShading &light = scene.lights[i];
        IncomingLight incoming = direction_to(scene, light, point);
        // A light behind the surface, as the viewer sees it, is hidden by the surface itself.
        if (!faces(point, incoming.delta)) continue;
        find_strength(light, incoming);
        if (!(incoming.strength > 0.0f)) continue;
        ++rays.shadow;
        const ShadowRay shadow = shadow_ray(light, incoming, point);
        const float share = unblocked_share(scene, light, shadow, point.left);
        if (recorder) recorder->casts(i, shadow, point, share);
        incoming.strength *= share;
        if (!(incoming.strength > 0.0f)) continue;
        const float n_l = dot(point.normal, incoming.to_light);
        float highlight = 0.0f;
        if (surface.specular > 0.0f) {
            // R.V with R = 2 (N.L) N - L.
            const float r_v = (2.0f * n_l) * dot(point.normal, to_viewer) - dot(incoming.to_light, to_viewer);
            highlight = surface.specular * pow_unit(r_v > 0.0f ? r_v : 0.0f, surface.exponent);
        }
        Color lit;
        for (int channel = 0; channel < 3; ++channel) {
            lit[channel] = (light.emission[channel] * incoming.strength) *
                           (diffuse[channel] * n_l + highlight * surface.highlight_color[channel]);
            color[channel] += lit[channel];
        }
        if (recorder) recorder->lights(lit);
    }
    return color;
}

void add_weighted(Color &sum, float weight, const Color &color) {
    sum.x += weight * color.x;
    sum.y += weight * color.y;
    sum.z += weight * color.z;
}

/// Adds the colour that arrives along a primary ray.
void trace(const KernelScene &scene, const Ray &primary, const Media &media, uint32_t max_depth, KernelScratch &scratch,
           RayRecorder *recorder, Color &color) {
    scratch.pending.clear();
    PendingRay next{primary, 0, 1.0f, no_triangle, media};
    const auto another_ray = [&] {
        if (scratch.pending.empty()) return false;
        next = scratch.pending.back();
        scratch.pending.pop_back();
        return true;
    };
    const auto shows = [&](float weight, const Color &local) {
        add_weighted(color, weight, local);
        if (recorder) recorder->shows(weight, local);
    };
    do {
        const PreparedRay ray(next.ray, scene.geometry.bounds);
        const Hit hit = closest_hit(scene.geometry, ray, std::numeric_limits<float>::max(), next.left_triangle);
        if (recorder) recorder->meets(next, hit);
        if (hit.triangle_id == no_triangle) {
            shows(next.weight, scene.background);
            continue;
        }
        const SurfacePoint point = surface_point(scene, ray, hit);
        const SurfaceShading &surface = *point.surface;
        if (surface.is_light) {
            shows(next.weight, surface.emission);
            continue;
        }

        const bool deeper = next.depth < max_depth;
        float reflection = deeper ? surface.reflection : 0.0f;
        float transmission = deeper ? surface.transmission : 0.0f;
        Refraction through{ray.dir, 0.0f, next.media};
        if (scene.has_refraction && transmission > 0.0f) {
            through = refract(scene, next.media, point.surface_number, ray.dir, point.normal);
            reflection += transmission * through.reflection;
            transmission -= transmission * through.reflection;
        }
        if (reflection > 0.0f && transmission > 0.0f) {
            if (next.weight * reflection < least_branch_weight) reflection = 0.0f;
            if (next.weight * transmission < least_branch_weight) transmission = 0.0f;
        }
        const float local_share = (1.0f - surface.replaced * reflection) - surface.replaced * transmission;
        if (local_share > 0.0f) {
            shows(next.weight * local_share, local_color(scene, point, -ray.dir, scratch.rays, recorder));
        }
        if (transmission > 0.0f) {
            ++scratch.rays.secondary;
            if (recorder) recorder->sends(false);
            scratch.pending.push_back({{offset_point(point, point.scale, -1.0f), through.dir},
                                       next.depth + 1,
                                       next.weight * transmission,
                                       point.left,
                                       through.media});
        }
        if (reflection > 0.0f) {
            ++scratch.rays.secondary;
            if (recorder) recorder->sends(true);
            const float twice_n_d = 2.0f * dot(point.normal, ray.dir);
            const glm::vec3 mirrored = {ray.dir.x - twice_n_d * point.normal.x, ray.dir.y - twice_n_d * point.normal.y,
                                        ray.dir.z - twice_n_d * point.normal.z};
            scratch.pending.push_back({{offset_point(point, point.scale, 1.0f), normalize(mirrored)},
                                       next.depth + 1,
                                       next.weight * reflection,
                                       point.left,
                                       next.media});
        }
    } while (another_ray());
}

size_t scratch_bytes(const KernelScene &, const KernelFrame &) {
    return 0;
}

void render_tile(const KernelScene &scene, const KernelFrame &frame, Tile tile, KernelScratch &scratch) {
    for (uint32_t y = tile.y0; y < tile.y1; ++y) {
        for (uint32_t x = tile.x0; x < tile.x1; ++x) {
            const Color color = pixel_color(scene, frame, x, y, scratch, nullptr);
            uint8_t *const bytes = frame.rgba8 + y * frame.rgba8_stride_bytes + size_t{x} * 4;
            for (int channel = 0; channel < 3; ++channel) bytes[channel] = pixel_byte(frame, color[channel]);
            bytes[3] = 255;
            if (!frame.radiance) continue;
            float *const light = frame.radiance + y * (frame.radiance_stride_bytes / sizeof(float)) + size_t{x} * 3;
            for (int channel = 0; channel < 3; ++channel) light[channel] = color[channel];
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

Color pixel_color(const KernelScene &scene, const KernelFrame &frame, uint32_t x, uint32_t y, KernelScratch &scratch,
                  RayRecorder *recorder) {
    const Camera &camera = frame.camera;
    const float inverse_width = 1.0f / static_cast<float>(frame.width_px);
    const float inverse_height = 1.0f / static_cast<float>(frame.height_px);
    const glm::vec3 eye_to_corner = camera.top_left - camera.eye;
    const uint32_t sample_count = frame.samples.columns * frame.samples.rows;
    Color color(0.0f);
    for (uint32_t sample = 0; sample < sample_count; ++sample) {
        const glm::vec2 place = sample_place(frame.samples, x, y, sample);
        const float u = (static_cast<float>(x) + place.x) * inverse_width;
        const float v = (static_cast<float>(y) + place.y) * inverse_height;
        const glm::vec3 to_pixel = {(eye_to_corner.x + camera.right.x * u) + camera.down.x * v,
                                    (eye_to_corner.y + camera.right.y * u) + camera.down.y * v,
                                    (eye_to_corner.z + camera.right.z * u) + camera.down.z * v};
        ++scratch.rays.primary;
        trace(scene, {camera.eye, normalize(to_pixel)}, frame.eye_media, frame.max_depth, scratch, recorder, color);
    }
    return color * (1.0f / static_cast<float>(sample_count));
}

uint8_t pixel_byte(const KernelFrame &frame, float channel) {
    return resolve_channel(displayed(channel, frame.tone_scale, frame.to_srgb));
}

const Kernel scalar_kernel = {Isa::scalar, scratch_bytes, render_tile, closest_hits, any_hits};

} // namespace glint
