// Four kinds of rays that a renderer asks about, made from a scene.
#include "bench/ray_classes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glint::bench {
namespace {

float dot(const Vector &a, const Vector &b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector &a, const Vector &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector normalize(const Vector &a) {
    return a * (1.0f / std::sqrt(dot(a, a)));
}

float max_abs(const Vector &a) {
    return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

/// Two unit vectors at right angles to each other and to the unit vector `n` (Duff et al. 2017, "Building an
/// orthonormal basis, revisited").
struct Basis {
    explicit Basis(const Vector &n) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z), b = n.x * n.y * a;
        u = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
        v = {b, sign + n.y * n.y * a, -n.y};
    }
    Vector u, v;
};

/// Unit normals of the scene's triangles, by triangle_id.
std::vector<Vector> triangle_normals(const Scene &scene) {
    std::vector<Vector> normals;
    normals.reserve(scene.triangle_count());
    for (uint32_t s = 0; s < scene.surface_count(); ++s) {
        const Mesh &mesh = *scene.surface_mesh(s);
        for (const Triangle &triangle : mesh.triangles) {
            const glm::dvec3 a = mesh.positions[triangle.a];
            const glm::dvec3 ab = glm::dvec3(mesh.positions[triangle.b]) - a;
            const glm::dvec3 ac = glm::dvec3(mesh.positions[triangle.c]) - a;
            const glm::dvec3 n{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
            normals.emplace_back(n * (1.0 / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z)));
        }
    }
    return normals;
}

RaySet primary_rays(const Camera &camera, uint32_t size_px) {
    constexpr uint32_t tile = 16, block = 4;
    RaySet rays("primary", RayQuestion::closest_hit);
    const float pixel = 1.0f / static_cast<float>(size_px);
    const auto add_pixel = [&](uint32_t x, uint32_t y) {
        const float u = (static_cast<float>(x) + 0.5f) * pixel, v = (static_cast<float>(y) + 0.5f) * pixel;
        const Vector to_pixel = camera.top_left - camera.eye + camera.right * u + camera.down * v;
        rays.add(camera.eye, normalize(to_pixel), std::numeric_limits<float>::max());
    };
    const uint32_t tiles = (size_px + tile - 1) / tile;
    for (uint32_t i = 0; i < tiles * tiles; ++i) {
        for (uint32_t j = 0; j < tile * tile; ++j) {
            const uint32_t in_block = j % (block * block), block_number = j / (block * block);
            const uint32_t x = i % tiles * tile + block_number % (tile / block) * block + in_block % block;
            const uint32_t y = i / tiles * tile + block_number / (tile / block) * block + in_block / block;
            if (x < size_px && y < size_px) add_pixel(x, y);
        }
    }
    return rays;
}

/// Uniform in [0, 1), the same for the same ray in every run (PCG hash: Jarzynski & Olano 2020, "Hash functions for GPU
/// rendering").
float random_unit(uint32_t ray, uint32_t dimension) {
    const uint32_t state = (ray * 2u + dimension) * 747796405u + 2891336453u;
    const uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return static_cast<float>(((word >> 22u) ^ word) >> 8u) * 0x1p-24f;
}

/// Malley's method: a point on the unit disc, lifted onto the hemisphere.
Vector cosine_direction(const Vector &normal, uint32_t ray) {
    const float radius_squared = random_unit(ray, 0);
    const float angle = 2.0f * std::numbers::pi_v<float> * random_unit(ray, 1);
    const float radius = std::sqrt(radius_squared);
    const Basis basis(normal);
    return normalize(basis.u * (radius * std::cos(angle)) + basis.v * (radius * std::sin(angle)) +
                     normal * std::sqrt(1.0f - radius_squared));
}

/// Adds the rays of the three later classes that one primary hit gives rise to.
struct HitRays {
    RaySet shadow{"shadow", RayQuestion::any_hit};
    RaySet mirror{"mirror", RayQuestion::closest_hit};
    RaySet diffuse{"diffuse", RayQuestion::closest_hit};

    void add(const Point &org, const Vector &dir, float t, const Vector &triangle_normal, const Point &light) {
        constexpr float shadow_t_max = 1.0f - 1e-4f;
        // Some hundred times the rounding of a hit's position: no tracer finds the triangle again.
        constexpr float offset_of_scale = 1e-5f;

        const Point point = org + dir * t;
        const Vector normal = dot(triangle_normal, dir) > 0.0f ? -triangle_normal : triangle_normal;
        const Point above = point + normal * (offset_of_scale * std::max(max_abs(point), max_abs(dir * t)));
        const auto number = static_cast<uint32_t>(shadow.size());
        constexpr float far = std::numeric_limits<float>::max();
        shadow.add(light, point - light, shadow_t_max);
        mirror.add(above, normalize(dir - normal * (2.0f * dot(normal, dir))), far);
        diffuse.add(above, cosine_direction(normal, number), far);
    }
};

} // namespace

Viewpoint viewpoint_of(const Scene &scene) {
    return {scene.camera(), scene.light_positions().front()};
}

Viewpoint viewpoint_framing(const Scene &scene) {
    constexpr float limit = std::numeric_limits<float>::max();
    Point lo(limit), hi(-limit);
    const auto for_each_position = [&](const auto &visit) {
        for (uint32_t s = 0; s < scene.surface_count(); ++s) {
            for (const Point &position : scene.surface_mesh(s)->positions) visit(position);
        }
    };
    for_each_position([&](const Point &p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    });
    const Point centre = (lo + hi) * 0.5f;
    const float radius = 0.5f * std::sqrt(dot(hi - lo, hi - lo));

    const Vector back = normalize({0.3f, 0.4f, 1.0f});
    const Vector right = normalize(cross({0.0f, 1.0f, 0.0f}, back)), up = cross(back, right);
    const float half_view = std::tan(22.5f * std::numbers::pi_v<float> / 180.0f);
    float distance = 0.0f;
    for_each_position([&](const Point &p) {
        const Vector q = p - centre;
        const float needed = std::max(std::abs(dot(q, up)) / 0.8f, std::abs(dot(q, right))) / half_view;
        distance = std::max(distance, dot(q, back) + needed);
    });

    Viewpoint viewpoint;
    const Vector half_right = right * (half_view * distance), half_up = up * (half_view * distance);
    viewpoint.camera.eye = centre + back * distance;
    viewpoint.camera.top_left = centre - half_right + half_up;
    viewpoint.camera.right = half_right * 2.0f;
    viewpoint.camera.down = half_up * -2.0f;
    viewpoint.light = centre + Vector(1.0f, 1.5f, 1.0f) * (2.0f * radius);
    return viewpoint;
}

std::vector<RaySet> make_ray_classes(const Scene &scene, const RayQuery &query, const Viewpoint &viewpoint,
                                     uint32_t size_px) {
    RaySet primary = primary_rays(viewpoint.camera, size_px);
    RayAnswers answers(primary);
    query.closest_hits(primary.batch(0, primary.size()), {answers.t.data(), answers.triangle_id.data()});

    const std::vector<Vector> normals = triangle_normals(scene);
    HitRays later;
    for (size_t i = 0; i < primary.size(); ++i) {
        if (answers.triangle_id[i] == no_triangle) continue;
        later.add({primary.org_x[i], primary.org_y[i], primary.org_z[i]},
                  {primary.dir_x[i], primary.dir_y[i], primary.dir_z[i]}, answers.t[i], normals[answers.triangle_id[i]],
                  viewpoint.light);
    }
    std::vector<RaySet> classes;
    classes.push_back(std::move(primary));
    classes.push_back(std::move(later.shadow));
    classes.push_back(std::move(later.mirror));
    classes.push_back(std::move(later.diffuse));
    return classes;
}

} // namespace glint::bench
