// Measures a finished tree.
#pragma once

#include <glint/accel.hpp>

#include "accel/bvh/wide_bvh.hpp"
#include "accel/kd_tree.hpp"

namespace glint {

/// Everything but bytes and build_seconds.
[[nodiscard]] AccelStatistics measure_tree(const KdTree &tree, uint32_t triangle_count);
[[nodiscard]] AccelStatistics measure_bvh(const WideBvh &bvh, uint32_t triangle_count);

} // namespace glint
