// Axis-aligned boxes.
#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace glint {

/// Closed box from lo to hi; empty (lo > hi) until something is put in.
struct Box {
    glm::vec3 lo{std::numeric_limits<float>::infinity()};
    glm::vec3 hi{-std::numeric_limits<float>::infinity()};

    void extend(const glm::vec3 &p) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    void extend(const Box &other) {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
    [[nodiscard]] bool empty() const { return lo.x > hi.x || lo.y > hi.y || lo.z > hi.z; }

    /// Half the surface area, in double: areas of tiny and huge scenes neither vanish nor overflow.
    [[nodiscard]] double half_area() const {
        const double x = double(hi.x) - lo.x, y = double(hi.y) - lo.y, z = double(hi.z) - lo.z;
        return x * y + (y * z + z * x);
    }
};

} // namespace glint
