// Batches of rays for packet kernels.
#include "kernel/ray_batches.hpp"

#include <cfloat>
#include <cmath>

#include "math/vec.hpp"

namespace glint::test {

namespace {

/// Numbers of rays round the sizes that matter to kernels: vectors of 4 to 16, blocks of 16, groups of 256.
constexpr uint32_t counts[] = {1, 3, 16, 37, 64, 255, 256, 256, 256, 257, 512, 700};

/// In [-1, 1]: where a ray of a group stands in its 16 x 16 pixels, which come in blocks of 4 x 4.
struct PlaceInGroup {
    float x, y;
    explicit PlaceInGroup(uint32_t ray) {
        const uint32_t block = ray % 256 / 16, within = ray % 16;
        x = static_cast<float>(block % 4 * 4 + within % 4) / 7.5f - 1.0f;
        y = static_cast<float>(block / 4 * 4 + within / 4) / 7.5f - 1.0f;
    }
};

/// Two vectors across a direction.
struct Across {
    Vector u, v;
    explicit Across(const Vector &d) {
        const bool mostly_x = std::abs(d.x) > 0.7f;
        u = normalize(mostly_x ? Vector(-d.y, d.x, 0.0f) : Vector(0.0f, -d.z, d.y));
        v = {d.y * u.z - d.z * u.y, d.z * u.x - d.x * u.z, d.x * u.y - d.y * u.x};
    }
    [[nodiscard]] Vector at(const PlaceInGroup &place) const { return u * place.x + v * place.y; }
};

/// Evenly spread by magnitude.
float between_magnitudes(Random &random, float lo, float hi) {
    return std::exp(random.uniform(std::log(lo), std::log(hi)));
}

Vector axis_direction(Random &random) {
    Vector dir(0.0f);
    dir[static_cast<int>(random.below(3))] = random.below(2) ? 1.0f : -1.0f;
    for (int i = 0; i < 3; ++i) dir[i] = dir[i] == 0.0f && random.below(2) ? -0.0f : dir[i];
    return dir;
}

bool is_ray(const Ray &ray) {
    return max_abs(ray.dir) > 0.0f && std::isfinite(max_abs(ray.dir));
}

enum Kind : uint32_t {
    camera,       // one origin, a window
    targets,      // one origin, vertices and edges of neighbouring triangles
    shadows,      // from a light to points of the mesh
    leaving,      // from points of neighbouring triangles, or a little off them
    mirrored,     // origins side by side, directions that fan out
    orthographic, // origins side by side, one direction
    star,         // one origin, all ways
    scattered,    // nothing in common
    jittered,     // one awkward ray, again and again with small changes
    patchwork,    // each block of another kind
    kind_count
};

} // namespace

void RayRows::add(const Ray &ray, float limit) {
    org_x.push_back(ray.org.x);
    org_y.push_back(ray.org.y);
    org_z.push_back(ray.org.z);
    dir_x.push_back(ray.dir.x);
    dir_y.push_back(ray.dir.y);
    dir_z.push_back(ray.dir.z);
    t_max.push_back(limit);
}

RayBatch RayRows::batch() const {
    return {count(), org_x.data(), org_y.data(), org_z.data(), dir_x.data(), dir_y.data(), dir_z.data(), t_max.data()};
}

BatchSet::BatchSet(const Mesh &mesh) : mesh_(mesh), singles_(mesh) {
    Box bounds;
    for (const Point &p : mesh.positions) bounds.extend(p);
    center_ = (bounds.lo + bounds.hi) * 0.5f;
    reach_ = max_abs(bounds.hi - bounds.lo);
}

Point BatchSet::special_point(Random &random, uint32_t triangle) const {
    const Triangle &t = mesh_.triangles[triangle % mesh_.triangles.size()];
    const Point a = mesh_.positions[t.a], b = mesh_.positions[t.b], c = mesh_.positions[t.c];
    switch (random.below(5)) {
    case 0:
        return a;
    case 1:
        return (b + c) * 0.5f;
    case 2:
        return a + (b - a) * random.uniform(0.0f, 1.0f);
    case 3:
        return (a + b + c) / 3.0f;
    default: {
        const float u = random.uniform(0.0f, 1.0f), v = random.uniform(0.0f, 1.0f - u);
        return a + (b - a) * u + (c - a) * v;
    }
    }
}

/// Near the mesh mostly, also on it, also far away.
Point BatchSet::any_origin(Random &random) const {
    switch (random.below(8)) {
    case 0:
        return special_point(random, random.next());
    case 1:
        return center_ + random.direction() * (reach_ * between_magnitudes(random, 1.0f, 1e6f));
    default:
        return center_ + random.in_box(Point(-reach_), Point(reach_));
    }
}

std::vector<Ray> BatchSet::rays(Random &random, uint32_t kind, uint32_t number, uint32_t count) const {
    std::vector<Ray> made;
    const uint32_t first_triangle = random.next();
    const Point origin = any_origin(random), target = special_point(random, first_triangle);
    const Vector way = target - origin;
    const Vector axis = max_abs(way) > 0.0f ? normalize(way) : Vector(0.0f, 0.0f, 1.0f);
    const Across across(axis);
    const bool unit_length = random.below(2) != 0;
    const auto sized = [&](const Vector &dir) { return unit_length && max_abs(dir) > 0.0f ? normalize(dir) : dir; };
    const float width = between_magnitudes(random, 1e-5f, 4.0f);
    switch (kind) {
    case camera:
        for (uint32_t i = 0; i < count; ++i) {
            made.push_back({origin, sized(axis + across.at(PlaceInGroup(i)) * width)});
        }
        break;
    case targets:
    case shadows:
        for (uint32_t i = 0; i < count; ++i) {
            const Vector dir = special_point(random, first_triangle + random.below(kind == targets ? 6 : 40)) - origin;
            made.push_back({origin, kind == targets ? sized(dir) : dir});
        }
        break;
    case leaving: {
        const float off = reach_ * between_magnitudes(random, 1e-9f, 1e-2f);
        const bool all_ways = random.below(2) != 0;
        for (uint32_t i = 0; i < count; ++i) {
            const Point from = special_point(random, first_triangle + random.below(40));
            const Vector dir = all_ways ? random.direction() : axis + random.direction() * (0.5f * width);
            made.push_back({from + random.direction() * off, sized(dir)});
        }
        break;
    }
    case mirrored: {
        const float spread = reach_ * between_magnitudes(random, 1e-5f, 1.0f);
        const float fan = random.below(3) == 0 ? -width : width;
        for (uint32_t i = 0; i < count; ++i) {
            const Vector offset = across.at(PlaceInGroup(i));
            made.push_back({origin + offset * spread, sized(axis + offset * fan)});
        }
        break;
    }
    case orthographic: {
        const Vector dir = random.below(2) ? axis_direction(random) : axis;
        const Across sideways(dir);
        const float spread = reach_ * between_magnitudes(random, 1e-3f, 1.0f);
        const Point through = random.below(2) ? target : center_;
        for (uint32_t i = 0; i < count; ++i) {
            made.push_back({through - dir * (2.0f * reach_) + sideways.at(PlaceInGroup(i)) * spread, dir});
        }
        break;
    }
    case star:
        for (uint32_t i = 0; i < count; ++i) {
            made.push_back({origin, random.below(4) == 0 ? axis_direction(random) : random.direction()});
        }
        break;
    case jittered: {
        const Ray ray = singles_.ray(number);
        const float jitter = between_magnitudes(random, 1e-8f, 1e-2f);
        const bool also_the_origin = random.below(2) != 0;
        for (uint32_t i = 0; i < count; ++i) {
            made.push_back(ray);
            if (random.below(4) == 0) continue;
            made.back().dir += random.direction() * jitter;
            if (also_the_origin) made.back().org += random.direction() * (jitter * reach_);
        }
        break;
    }
    case patchwork:
        while (made.size() < count) {
            const uint32_t block = 16 - static_cast<uint32_t>(made.size()) % 16;
            const uint32_t other = random.below(patchwork);
            for (const Ray &ray : rays(random, other, number + block, block)) made.push_back(ray);
        }
        made.resize(count);
        break;
    default:
        for (uint32_t i = 0; i < count; ++i) made.push_back(singles_.ray(number * 1024 + i));
    }
    return made;
}

RayRows BatchSet::batch(uint32_t number) const {
    Random random(number);
    const uint32_t kind = number % kind_count, count = counts[random.below(std::size(counts))];
    const uint32_t limits = kind == shadows ? 4 : random.below(4);
    RayRows rows;
    for (const Ray &ray : rays(random, kind, number, count)) {
        if (!is_ray(ray)) continue;
        const float length = std::sqrt(dot(ray.dir, ray.dir));
        rows.add(ray, limits == 0                           ? random.uniform(0.0f, 3.0f * reach_) / length
                      : limits == 1 && random.below(8) == 0 ? 0.0f
                      : limits == 4                         ? 1.0f - 0x1p-22f
                                                            : FLT_MAX);
    }
    return rows;
}

} // namespace glint::test
