// Random numbers that are the same on every machine (std:: distributions are not).
#pragma once

#include <cmath>
#include <cstdint>

#include <glm/vec3.hpp>

namespace glint::test {

/// PCG32 (O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms").
class Random {
public:
    explicit Random(uint64_t seed) : state_(seed * 2 + 1) { next(); }

    uint32_t next() {
        const uint64_t old = state_;
        state_ = old * 6364136223846793005u + 1442695040888963407u;
        const auto shifted = static_cast<uint32_t>(((old >> 18) ^ old) >> 27);
        const auto rotation = static_cast<uint32_t>(old >> 59);
        return (shifted >> rotation) | (shifted << ((32 - rotation) & 31));
    }
    /// Below n, n > 0.
    uint32_t below(uint32_t n) { return static_cast<uint32_t>((uint64_t{next()} * n) >> 32); }
    /// In [lo, hi).
    float uniform(float lo, float hi) { return lo + (hi - lo) * (static_cast<float>(next() >> 8) * 0x1p-24f); }
    glm::vec3 in_box(const glm::vec3 &lo, const glm::vec3 &hi) {
        const float x = uniform(lo.x, hi.x), y = uniform(lo.y, hi.y), z = uniform(lo.z, hi.z);
        return {x, y, z};
    }
    /// Evenly over the unit sphere, by rejection.
    glm::vec3 direction() {
        while (true) {
            const glm::vec3 p = in_box(glm::vec3(-1.0f), glm::vec3(1.0f));
            const float square = p.x * p.x + p.y * p.y + p.z * p.z;
            if (square > 1e-4f && square <= 1.0f) return p / std::sqrt(square);
        }
    }

private:
    uint64_t state_;
};

} // namespace glint::test
