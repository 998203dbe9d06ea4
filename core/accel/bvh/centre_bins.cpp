// The cheapest of the splits between bins.
#include "accel/bvh/centre_bins.hpp"

namespace glint {

BinSplit best_split(const CentreBins &bins, const Binning &binning) {
    BinSplit best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!binning.divides(axis)) continue;
        Bounds left[bin_count];
        uint32_t left_count[bin_count];
        Bounds box;
        uint32_t count = 0;
        for (int bin = 1; bin < bin_count; ++bin) {
            box.extend(bins.box[axis][bin - 1]);
            count += bins.count[axis][bin - 1];
            left[bin] = box;
            left_count[bin] = count;
        }
        box = {};
        count = 0;
        for (int bin = bin_count - 1; bin > 0; --bin) {
            box.extend(bins.box[axis][bin]);
            count += bins.count[axis][bin];
            if (count == 0 || left_count[bin] == 0) continue;
            const float cost =
                left[bin].half_area() * bvh_leaf_cost(left_count[bin]) + box.half_area() * bvh_leaf_cost(count);
            if (cost < best.cost) best = {axis, bin, cost, left[bin], box, left_count[bin]};
        }
    }
    return best;
}

} // namespace glint
