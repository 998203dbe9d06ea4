// Boxes as the hierarchy's builder works with them: in registers of four floats.
#pragma once

#include <cstdint>
#include <limits>

#include "math/bits.hpp"

namespace glint {

/// Four floats that the compiler may take as one register.
struct alignas(16) Four {
    float v[4];
};
inline Four lesser(const Four &a, const Four &b) {
    Four r;
    for (int i = 0; i < 4; ++i) r.v[i] = a.v[i] < b.v[i] ? a.v[i] : b.v[i];
    return r;
}
inline Four greater(const Four &a, const Four &b) {
    Four r;
    for (int i = 0; i < 4; ++i) r.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
    return r;
}
inline Four sum(const Four &a, const Four &b) {
    Four r;
    for (int i = 0; i < 4; ++i) r.v[i] = a.v[i] + b.v[i];
    return r;
}

struct Bounds {
    static constexpr float infinity = std::numeric_limits<float>::infinity();

    Four lo{{infinity, infinity, infinity, infinity}}, hi{{-infinity, -infinity, -infinity, -infinity}};

    void extend(const Four &point) {
        lo = lesser(lo, point);
        hi = greater(hi, point);
    }
    void extend(const Bounds &other) {
        lo = lesser(lo, other.lo);
        hi = greater(hi, other.hi);
    }
    [[nodiscard]] float half_area() const {
        const float x = hi.v[0] - lo.v[0], y = hi.v[1] - lo.v[1], z = hi.v[2] - lo.v[2];
        return x * y + (y * z + z * x);
    }
};

/// A triangle's box. The fourth lane of `hi` is its number, as the bits of a small float.
struct BoundedTriangle {
    Four lo, hi;

    [[nodiscard]] Four centre() const { return sum(lo, hi); } ///< twice
    [[nodiscard]] uint32_t triangle_id() const { return bit_cast<uint32_t>(hi.v[3]); }
};

/// Some triangles that stand in a row, and where.
struct TriangleRange {
    uint32_t begin, end;
    Bounds box, centres;

    [[nodiscard]] uint32_t count() const { return end - begin; }
};

} // namespace glint
