// Places on a glowing mesh that its light comes from.
#include "kernel/light_places.hpp"

#include <algorithm>
#include <cmath>

#include "math/bits.hpp"
#include "math/hash.hpp"
#include "scene/triangle_area.hpp"

namespace glint {

namespace {

/// The bits in reverse: the first n numbers' reverses are spread evenly, for any n (van der Corput 1935).
uint32_t reversed(uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

} // namespace

std::vector<float> cumulative_area(const Mesh &mesh) {
    std::vector<double> sums;
    double sum = 0.0;
    for (const Triangle &triangle : mesh.triangles) {
        const glm::dvec3 n = doubled_area_normal(mesh, triangle);
        sum += std::sqrt((n.x * n.x + n.y * n.y) + n.z * n.z);
        sums.push_back(sum);
    }
    std::vector<float> shares;
    for (const double part : sums) shares.push_back(static_cast<float>(part / sum));
    shares.back() = 1.0f;
    return shares;
}

glm::vec3 place_on(const LightArea &area, float u, float v) {
    const float *const end = area.cumulative + area.mesh->triangles.size();
    const float *const found = std::upper_bound(area.cumulative, end - 1, u);
    const auto i = static_cast<size_t>(found - area.cumulative);
    const float begin = i == 0 ? 0.0f : area.cumulative[i - 1];
    const float width = *found - begin;
    const float within = width > 0.0f ? (u - begin) / width : 0.5f;

    const Triangle &t = area.mesh->triangles[i];
    const glm::vec3 &a = area.mesh->positions[t.a], &b = area.mesh->positions[t.b], &c = area.mesh->positions[t.c];
    const float away_from_a = std::sqrt(within);
    const float to_a = 1.0f - away_from_a, to_b = away_from_a * (1.0f - v), to_c = away_from_a * v;
    return {(a.x * to_a + b.x * to_b) + c.x * to_c, (a.y * to_a + b.y * to_b) + c.y * to_c,
            (a.z * to_a + b.z * to_b) + c.z * to_c};
}

glm::vec3 light_place(const LightShading &light, uint32_t seed, const glm::vec3 &point) {
    uint32_t random = scrambled(seed, light.first_triangle);
    for (const float coordinate : {point.x, point.y, point.z}) {
        random = scrambled(random, bit_cast<uint32_t>(coordinate));
    }
    const float jitter = unit_number(scrambled(random, light.sample));
    const float u = (static_cast<float>(light.sample) + jitter) / static_cast<float>(light.sample_count);
    const float v = unit_number(reversed(light.sample) ^ random);
    return place_on(*light.area, u < 1.0f ? u : 1.0f - 0x1p-24f, v);
}

} // namespace glint
