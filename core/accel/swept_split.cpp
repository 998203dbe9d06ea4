// Split search for small nodes: walk over all triangle boundaries in order, counting what lies on either side.
#include "accel/split.hpp"

#include <algorithm>

namespace glint {

namespace {

/// Boundaries along one axis, each list sorted. A thread keeps one for all its nodes, so that nothing is allocated.
struct Boundaries {
    std::vector<float> begins, ends; ///< of references with an extent along the axis
    std::vector<float> planars;      ///< of references without

    void gather(std::span<const Reference> references, int axis) {
        begins.clear();
        ends.clear();
        planars.clear();
        for (const Reference &reference : references) {
            const float lo = component(reference.bounds.lo, axis), hi = component(reference.bounds.hi, axis);
            if (lo == hi) {
                planars.push_back(lo);
            } else {
                begins.push_back(lo);
                ends.push_back(hi);
            }
        }
        std::sort(begins.begin(), begins.end());
        std::sort(ends.begin(), ends.end());
        std::sort(planars.begin(), planars.end());
    }
};

} // namespace

Split find_swept_split(std::span<const Reference> references, const Box &cell, const CostModel &cost) {
    static thread_local Boundaries boundaries;
    BestSplit best(cell, cost);
    for (int axis = 0; axis < 3; ++axis) {
        if (!(component(cell.hi, axis) > component(cell.lo, axis))) continue;
        boundaries.gather(references, axis);
        const auto &[begins, ends, planars] = boundaries;
        size_t begun = 0, ended = 0, flat = 0; // boundaries strictly below the plane; for ends: below or in it
        while (begun < begins.size() || ended < ends.size() || flat < planars.size()) {
            float plane = std::numeric_limits<float>::infinity();
            if (begun < begins.size()) plane = std::min(plane, begins[begun]);
            if (ended < ends.size()) plane = std::min(plane, ends[ended]);
            if (flat < planars.size()) plane = std::min(plane, planars[flat]);

            while (ended < ends.size() && ends[ended] == plane) ++ended;
            const size_t flat_below = flat;
            while (flat < planars.size() && planars[flat] == plane) ++flat;
            best.offer(axis, plane, begun + flat_below, flat - flat_below,
                       (ends.size() - ended) + (planars.size() - flat));
            while (begun < begins.size() && begins[begun] == plane) ++begun;
        }
    }
    return best.best();
}

} // namespace glint
