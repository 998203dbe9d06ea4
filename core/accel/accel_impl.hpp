// What stands behind the public Accel: read by the kernels.
#pragma once

#include <memory>

#include <glint/accel.hpp>

#include "accel/kd_tree.hpp"
#include "accel/triangle_data.hpp"

namespace glint {

struct Accel::Impl {
    std::shared_ptr<const Scene> scene;
    AccelKind kind = AccelKind::kdtree;
    TriangleData triangles;
    KdTree tree; ///< without nodes for AccelKind::brute
    AccelStatistics statistics;
};

} // namespace glint
