// Places on a glowing mesh that its light comes from.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "kernel/kernel.hpp"

namespace glint {

/// Share of a mesh's area up to and including each of its triangles; the last is 1.
[[nodiscard]] std::vector<float> cumulative_area(const Mesh &mesh);

/// The place on the mesh that u and v in [0, 1) stand for: evenly spread numbers give evenly spread places.
[[nodiscard]] glm::vec3 place_on(const LightArea &area, float u, float v);

/// Where a light with an area is seen from a point: at random, but always the same for the same point and seed. A
/// light's samples are spread over its area in as many parts as there are samples.
[[nodiscard]] glm::vec3 light_place(const LightShading &light, uint32_t seed, const glm::vec3 &point);

} // namespace glint
