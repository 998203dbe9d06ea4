// Vector arithmetic whose every rounding is pinned down: the same bits on every machine and for every GLM version.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace glint {

/// v[axis] for an axis known at run time: a load, where GLM's own operator[] is a chain of branches.
template <typename T> [[nodiscard]] T &component(glm::vec<3, T> &v, int axis) {
    return (&v.x)[axis];
}
template <typename T> [[nodiscard]] T component(const glm::vec<3, T> &v, int axis) {
    return (&v.x)[axis];
}

[[nodiscard]] inline float dot(const glm::vec3 &a, const glm::vec3 &b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/// Unit length; the argument is not zero and its square neither over- nor underflows.
[[nodiscard]] inline glm::vec3 normalize(const glm::vec3 &a) {
    const float inverse_length = 1.0f / std::sqrt(dot(a, a));
    return {a.x * inverse_length, a.y * inverse_length, a.z * inverse_length};
}

/// The largest absolute component.
template <typename T> [[nodiscard]] T max_abs(const glm::vec<3, T> &a) {
    const T x = std::abs(a.x), y = std::abs(a.y), z = std::abs(a.z);
    const T xy = x > y ? x : y;
    return xy > z ? xy : z;
}

} // namespace glint
