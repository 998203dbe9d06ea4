// Splits ranges of triangles in place.
#include "accel/bvh/range_splitter.hpp"

#include <utility>

#include "accel/bvh/binary_bvh.hpp"

namespace glint {

bool RangeSplitter::split(const TriangleRange &range, uint32_t depth, TriangleRange &left, TriangleRange &right) {
    if (range.count() <= 2) return false;
    const Binning binning(range.centres);
    const std::span<BoundedTriangle> items = items_.subspan(range.begin, range.count());
    BinSplit split;
    if (depth < max_binary_depth / 2) {
        bins_ = {};
        binning.put(items, bins_);
        split = best_split(bins_, binning);
    }
    const float area = range.box.half_area();
    if (range.count() <= max_bvh_leaf && !(split.cost + area < bvh_leaf_cost(range.count()) * area)) return false;
    if (split.axis < 0) {
        halve(range, left, right);
        return true;
    }
    left = {range.begin, range.begin + split.left_count, split.left, {}};
    right = {left.end, range.end, split.right, {}};
    uint32_t i = 0, j = range.count();
    while (true) {
        for (; i < j; ++i) {
            const Four centre = items[i].centre();
            if (binning.bin(centre, split.axis) >= split.bin) break;
            left.centres.extend(centre);
        }
        for (; i < j; --j) {
            const Four centre = items[j - 1].centre();
            if (binning.bin(centre, split.axis) < split.bin) break;
            right.centres.extend(centre);
        }
        if (i == j) break;
        std::swap(items[i], items[j - 1]);
    }
    return true;
}

// For triangles that all have the same centre, and where the hierarchy gets too deep.
void RangeSplitter::halve(const TriangleRange &range, TriangleRange &left, TriangleRange &right) {
    const uint32_t middle = range.begin + range.count() / 2;
    left = {range.begin, middle, {}, {}};
    right = {middle, range.end, {}, {}};
    for (TriangleRange *half : {&left, &right}) {
        for (uint32_t i = half->begin; i < half->end; ++i) {
            half->box.extend({items_[i].lo, items_[i].hi});
            half->centres.extend(items_[i].centre());
        }
    }
}

} // namespace glint
