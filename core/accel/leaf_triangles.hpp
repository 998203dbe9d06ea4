// How a leaf's triangles lie in memory: coordinate by coordinate, so that a vector register takes several triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "accel/triangle_data.hpp"
#include "math/bits.hpp"

namespace glint {

/// A leaf with n references, the first of them number f of the tree, owns the words 10 f .. 10 (f + n):
///
///     a.x[n]  a.y[n]  a.z[n]  b.x[n]  b.y[n]  b.z[n]  c.x[n]  c.y[n]  c.z[n]  triangle_id[n]
///
/// the first nine as float bit patterns. Behind the last leaf lie leaf_padding words more, so that a full vector may be
/// loaded from any of these arrays.
inline constexpr size_t words_per_reference = 10;
inline constexpr size_t leaf_padding = 16;

/// Reads one leaf.
class LeafTriangles {
public:
    LeafTriangles(const uint32_t *words, uint32_t first_reference, uint32_t count)
        : words_(words + words_per_reference * first_reference), count_(count) {}

    [[nodiscard]] uint32_t count() const { return count_; }
    [[nodiscard]] uint32_t triangle_id(uint32_t i) const { return words_[9 * size_t{count_} + i]; }
    [[nodiscard]] TriangleCorners corners(uint32_t i) const {
        const auto at = [&](int row) { return bit_cast<float>(words_[row * size_t{count_} + i]); };
        return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8)}};
    }

private:
    const uint32_t *words_;
    uint32_t count_;
};

/// Writes one leaf to where LeafTriangles will read it.
inline void write_leaf(uint32_t *words, const uint32_t *triangle_ids, uint32_t count,
                       std::span<const TriangleCorners> corners) {
    for (uint32_t i = 0; i < count; ++i) {
        const float *coordinates = &corners[triangle_ids[i]].a.x;
        for (size_t row = 0; row < 9; ++row) words[row * count + i] = bit_cast<uint32_t>(coordinates[row]);
        words[9 * size_t{count} + i] = triangle_ids[i];
    }
}

} // namespace glint
