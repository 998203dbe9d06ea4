// What many measurements of one thing boil down to.
#pragma once

#include <vector>

namespace glint::bench {

/// Order statistics of a set of measurements, in the measurements' own unit.
struct Summary {
    double median = 0.0; ///< mean of the middle two when their number is even
    double min = 0.0;
    double p95 = 0.0; ///< smallest measurement that at least 95 % of them do not exceed (nearest rank)
};

/// All zero for no measurements.
[[nodiscard]] Summary summarize(std::vector<double> measurements);

} // namespace glint::bench
