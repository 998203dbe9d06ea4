// Light through transmissive surfaces, where a scene asks for it.
#pragma once

#include "kernel/kernel.hpp"

namespace glint {

/// Share of a light that comes along a shadow ray, from t = 0 to t_max: the product of kt of all surfaces in the way,
/// each as often as the ray meets it. The light's own shape and the triangle `left` are not in the way.
[[nodiscard]] float share_through_glass(const KernelScene &scene, const LightShading &light, const Ray &ray,
                                        float t_max, uint32_t left);

} // namespace glint
