// Light through transmissive surfaces, where a scene asks for it.
#pragma once

#include "kernel/kernel.hpp"

namespace glint {

/// The next surface in the way of a shadow ray behind `last`, {0, no_triangle} at first; no_triangle where there is
/// none before t_max. The light's own shape and the triangle `left` are not in the way.
[[nodiscard]] Hit next_in_the_way(const KernelScene &scene, const LightShading &light, const PreparedRay &ray,
                                  const Hit &last, float t_max, uint32_t left);

/// Share of a light that comes along a shadow ray, from t = 0 to t_max: the product of kt of all surfaces in the way,
/// each as often as the ray meets it.
[[nodiscard]] float share_through_glass(const KernelScene &scene, const LightShading &light, const Ray &ray,
                                        float t_max, uint32_t left);

} // namespace glint
