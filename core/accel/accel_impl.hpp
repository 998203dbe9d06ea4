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
    KdTree tree;                                   ///< a single leaf for AccelKind::brute
    UninitializedVector<TriangleSurface> surfaces; ///< by triangle_id
    AccelStatistics statistics;
};

} // namespace glint
