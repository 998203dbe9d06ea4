// Split search for small cells: looks at every triangle's boundaries. Counting for all planes at once, without sorting
// or branching, is work for vector units; for so few references it is quicker than bins and finds the best plane.
#include "accel/split.hpp"

#include <algorithm>

namespace glint {

namespace {

/// Planes are looked at in blocks of this many.
constexpr size_t block = 4;
static_assert(exact_limit % block == 0);

/// The references along one axis, and planes to judge.
struct Extents {
    size_t count;
    float lo[exact_limit], hi[exact_limit];

    /// What lies on either side of planes through each reference's upper end, triangles in the plane below it.
    void count_at_ends(uint32_t *lower, uint32_t *upper) const {
        for (size_t first = 0; first < count; first += block) {
            int32_t below[block] = {}, not_above[block] = {};
            for (size_t r = 0; r < count; ++r) {
                for (size_t k = 0; k < block; ++k) {
                    const float plane = hi[first + k];
                    below[k] += (lo[r] < plane) | (hi[r] <= plane);
                    not_above[k] += hi[r] <= plane;
                }
            }
            for (size_t k = 0; k < block; ++k) {
                lower[first + k] = static_cast<uint32_t>(below[k]);
                upper[first + k] = static_cast<uint32_t>(count) - static_cast<uint32_t>(not_above[k]);
            }
        }
    }
    /// The same for planes through each lower end, triangles in the plane above it.
    void count_at_begins(uint32_t *lower, uint32_t *upper) const {
        for (size_t first = 0; first < count; first += block) {
            int32_t above[block] = {}, not_below[block] = {};
            for (size_t r = 0; r < count; ++r) {
                for (size_t k = 0; k < block; ++k) {
                    const float plane = lo[first + k];
                    above[k] += (hi[r] > plane) | (lo[r] >= plane);
                    not_below[k] += lo[r] >= plane;
                }
            }
            for (size_t k = 0; k < block; ++k) {
                upper[first + k] = static_cast<uint32_t>(above[k]);
                lower[first + k] = static_cast<uint32_t>(count) - static_cast<uint32_t>(not_below[k]);
            }
        }
    }
};

} // namespace

Split find_exact_split(std::span<const Reference> references, const Box &cell, const CostModel &cost) {
    Extents extents{};
    extents.count = references.size();
    const size_t padded = (references.size() + block - 1) / block * block;
    Split best;
    uint32_t lower[exact_limit], upper[exact_limit];
    float costs[exact_limit];
    for (int axis = 0; axis < 3; ++axis) {
        const Slices slices(cell, axis);
        if (slices.flat()) continue;
        for (size_t i = 0; i < references.size(); ++i) {
            extents.lo[i] = component(references[i].bounds.lo, axis);
            extents.hi[i] = component(references[i].bounds.hi, axis);
        }
        const auto offer = [&](const float *planes, float useless, bool planar_to_lower) {
            for (size_t i = 0; i < padded; ++i) {
                costs[i] = cost.split(slices.lower_share(planes[i]), lower[i], slices.upper_share(planes[i]), upper[i]);
            }
            for (size_t i = 0; i < references.size(); ++i) {
                if (costs[i] < best.cost && planes[i] != useless) {
                    best = {costs[i], planes[i], axis, planar_to_lower, lower[i], upper[i]};
                }
            }
        };
        extents.count_at_ends(lower, upper);
        offer(extents.hi, slices.hi, true);
        extents.count_at_begins(lower, upper);
        offer(extents.lo, slices.lo, false);
    }
    return best;
}

} // namespace glint
