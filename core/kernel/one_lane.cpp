// What packet kernels ask for one ray at a time.
#include "kernel/one_lane.hpp"

#include "kernel/glass_shadow.hpp"
#include "kernel/light_places.hpp"
#include "kernel/surface_detail.hpp"

namespace glint::one_lane {

namespace {

glm::vec3 vec(const float v[3]) {
    return {v[0], v[1], v[2]};
}

void write(const glm::vec3 &v, float to[3]) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

} // namespace

void detail(const KernelScene &scene, uint32_t surface, uint32_t triangle_id, const float point[3], const float dir[3],
            const float facet[3], float normal[3], float tint[3]) {
    const SurfaceDetail found = surface_detail(scene, surface, triangle_id, vec(point), vec(dir), vec(facet));
    write(found.normal, normal);
    write(found.tint, tint);
}

void place(const LightShading &light, uint32_t seed, const float point[3], float place[3]) {
    write(light_place(light, seed, vec(point)), place);
}

float glass_share(const KernelScene &scene, const LightShading &light, const float org[3], const float dir[3],
                  float t_max, uint32_t left) {
    return share_through_glass(scene, light, {vec(org), vec(dir)}, t_max, left);
}

void sample(const SampleGrid &grid, uint32_t x, uint32_t y, uint32_t sample, float place[2]) {
    const glm::vec2 at = sample_place(grid, x, y, sample);
    place[0] = at.x;
    place[1] = at.y;
}

} // namespace glint::one_lane
