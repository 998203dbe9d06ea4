// What packet kernels ask for one ray at a time, because few rays of few scenes need it: out of line, so that all
// kernels share the one answer, and in plain floats, so that nothing compiled for wide vectors stays behind in its
// callers.
#pragma once

#include "kernel/kernel.hpp"

namespace glint::one_lane {

/// surface_detail(): at `point`, for a ray along `dir`; writes the normal for shading, and the tint.
void detail(const KernelScene &scene, uint32_t surface, uint32_t triangle_id, const float point[3], const float dir[3],
            const float facet[3], float normal[3], float tint[3]);

/// light_place(): where light comes from to `point`.
void place(const LightShading &light, uint32_t seed, const float point[3], float place[3]);

/// share_through_glass()
float glass_share(const KernelScene &scene, const LightShading &light, const float org[3], const float dir[3],
                  float t_max, uint32_t left);

/// sample_place(): x and y within the pixel.
void sample(const SampleGrid &grid, uint32_t x, uint32_t y, uint32_t sample, float place[2]);

} // namespace glint::one_lane
