// Unit vectors, rounded once.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace glint {

/// v / |v| by way of double, of any v but 0.
[[nodiscard]] inline glm::vec3 unit(const glm::vec3 &v) {
    const glm::dvec3 d(v);
    const double inverse = 1.0 / std::sqrt((d.x * d.x + d.y * d.y) + d.z * d.z);
    return {static_cast<float>(d.x * inverse), static_cast<float>(d.y * inverse), static_cast<float>(d.z * inverse)};
}

} // namespace glint
