// Light through transmissive surfaces, where a scene asks for it.
#pragma once

#include "kernel/kernel.hpp"

namespace glint {

/// The first and the last surface that a shadow ray meets.
struct InTheWay {
    Hit first, last;
};

/// Share of a light that comes along a shadow ray, from t = 0 to t_max: the product of kt of all surfaces in the way,
/// each as often as the ray meets it. The light's own shape and the triangle `left` are not in the way. Who asks what
/// is in the way is told, where there is anything, and then the ray goes on behind what lets nothing through.
[[nodiscard]] float share_through_glass(const KernelScene &scene, const LightShading &light, const Ray &ray,
                                        float t_max, uint32_t left, InTheWay *in_the_way = nullptr);

} // namespace glint
