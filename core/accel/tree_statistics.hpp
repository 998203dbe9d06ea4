// Measures a finished tree.
#pragma once

#include <glint/accel.hpp>

#include "accel/kd_tree.hpp"

namespace glint {

/// Everything but triangles, bytes and build_seconds.
[[nodiscard]] AccelStatistics measure_tree(const KdTree &tree);

} // namespace glint
