// Splits ranges of triangles in place, one thread.
#pragma once

#include <span>

#include "accel/bvh/centre_bins.hpp"

namespace glint {

/// Splits ranges that lie in one array, in place.
class RangeSplitter {
public:
    explicit RangeSplitter(std::span<BoundedTriangle> items) : items_(items) {}

    /// False where a leaf is cheaper.
    [[nodiscard]] bool split(const TriangleRange &range, uint32_t depth, TriangleRange &left, TriangleRange &right);

private:
    void halve(const TriangleRange &range, TriangleRange &left, TriangleRange &right);

    std::span<BoundedTriangle> items_;
    CentreBins bins_;
};

} // namespace glint
