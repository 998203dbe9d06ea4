// What many measurements of one thing boil down to.
#include "bench/statistics.hpp"

#include <algorithm>
#include <cstddef>

namespace glint::bench {

Summary summarize(std::vector<double> measurements) {
    if (measurements.empty()) return {};
    std::sort(measurements.begin(), measurements.end());
    const size_t count = measurements.size();
    const size_t rank_95 = (count * 95 + 99) / 100; // ceil(0.95 count), exactly
    return {.median = 0.5 * (measurements[(count - 1) / 2] + measurements[count / 2]),
            .min = measurements.front(),
            .p95 = measurements[rank_95 - 1]};
}

} // namespace glint::bench
