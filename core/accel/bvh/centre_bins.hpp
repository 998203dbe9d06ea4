// Where the hierarchy's builder splits: triangles are put into bins by where their centres lie.
#pragma once

#include <span>

#include "accel/bvh/bounds.hpp"

namespace glint {

inline constexpr int bin_count = 16;

/// Triangles by where their centres lie.
struct CentreBins {
    Bounds box[3][bin_count];
    uint32_t count[3][bin_count] = {};

    void add(const CentreBins &other) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int bin = 0; bin < bin_count; ++bin) {
                box[axis][bin].extend(other.box[axis][bin]);
                count[axis][bin] += other.count[axis][bin];
            }
        }
    }
};

/// From a centre to its bin, along each axis.
struct Binning {
    Four origin, scale;

    explicit Binning(const Bounds &centres) : origin(centres.lo), scale{} {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centres.hi.v[axis] - centres.lo.v[axis];
            const float s = bin_count * (1.0f - 0x1p-20f) / extent;
            scale.v[axis] = extent > 0.0f && s < Bounds::infinity ? s : 0.0f;
        }
    }
    [[nodiscard]] bool divides(int axis) const { return scale.v[axis] > 0.0f; }
    [[nodiscard]] int bin(const Four &centre, int axis) const {
        return static_cast<int>((centre.v[axis] - origin.v[axis]) * scale.v[axis]);
    }
    void put(std::span<const BoundedTriangle> items, CentreBins &bins) const {
        for (const BoundedTriangle &item : items) {
            const Four centre = item.centre();
            const Bounds box{item.lo, item.hi};
            for (int axis = 0; axis < 3; ++axis) {
                const int b = bin(centre, axis);
                bins.box[axis][b].extend(box);
                ++bins.count[axis][b];
            }
        }
    }
};

/// Bins below `bin` along `axis` go left.
struct BinSplit {
    int axis = -1, bin = 0;
    float cost = Bounds::infinity; ///< times the box's half area
    Bounds left, right;
    uint32_t left_count = 0;
};

/// What so many triangles in one leaf cost, in steps through a node.
inline float bvh_leaf_cost(uint32_t count) {
    return static_cast<float>((count + 7) / 8);
}

/// By the surface area heuristic; without an axis where the bins do not divide the triangles.
[[nodiscard]] BinSplit best_split(const CentreBins &bins, const Binning &binning);

} // namespace glint
