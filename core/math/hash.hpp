// Random numbers that depend on what they are for alone, so that every thread and machine draws the same.
#pragma once

#include <cstdint>

namespace glint {

/// Every bit of the result depends on every bit of x (Wellons 2018, "Prospecting for hash functions": lowbias32).
[[nodiscard]] inline uint32_t scrambled(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

/// Of two numbers, in this order.
[[nodiscard]] inline uint32_t scrambled(uint32_t a, uint32_t b) {
    return scrambled(scrambled(a) ^ (b + 0x9e3779b9u));
}

/// A number in [0, 1), out of 2^24 evenly spaced ones.
[[nodiscard]] inline float unit_number(uint32_t random) {
    return static_cast<float>(random >> 8) * 0x1p-24f;
}

} // namespace glint
