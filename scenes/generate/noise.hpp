// Smooth random heights from an integer hash: the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#include "generate/mesh.hpp"

namespace glint::scenes {

/// A well mixed 32-bit number for a lattice point. Mixing steps: Chris Wellons, "lowbias32", 2018 (public domain).
[[nodiscard]] inline uint32_t lattice_hash(int32_t x, int32_t y, uint32_t seed) {
    uint32_t h = static_cast<uint32_t>(x) * 0x9e3779b1u ^ static_cast<uint32_t>(y) * 0x85ebca77u ^ seed;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return h ^ (h >> 16);
}

/// A value in [0, 1] and its slope.
struct NoiseSample {
    double value = 0.0;
    Vec2 slope{0.0};
};

/// Random values at the whole numbers, blended between them by a quintic whose first two derivatives vanish there.
[[nodiscard]] inline NoiseSample value_noise(Vec2 p, uint32_t seed) {
    const double floor_x = std::floor(p.x);
    const double floor_y = std::floor(p.y);
    const auto x = static_cast<int32_t>(floor_x);
    const auto y = static_cast<int32_t>(floor_y);
    const Vec2 f{p.x - floor_x, p.y - floor_y};
    const Vec2 blend = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    const Vec2 blend_slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);

    const auto corner = [&](int32_t dx, int32_t dy) { return lattice_hash(x + dx, y + dy, seed) / 4294967296.0; };
    const double v00 = corner(0, 0);
    const double along_x = corner(1, 0) - v00;
    const double along_y = corner(0, 1) - v00;
    const double mixed = corner(1, 1) - v00 - along_x - along_y;
    return {v00 + along_x * blend.x + along_y * blend.y + mixed * blend.x * blend.y,
            blend_slope * Vec2{along_x + mixed * blend.y, along_y + mixed * blend.x}};
}

} // namespace glint::scenes
