// What stands behind the public Accel: read by the kernels.
#pragma once

#include <memory>

#include <glint/accel.hpp>

#include "accel/bvh/wide_bvh.hpp"
#include "accel/kd_tree.hpp"
#include "accel/quadric_tree.hpp"
#include "accel/triangle_data.hpp"

namespace glint {

struct Accel::Impl {
    std::shared_ptr<const Scene> scene;
    AccelKind kind = AccelKind::kdtree; ///< not automatic
    KdTree tree;                        ///< a single leaf for AccelKind::brute; empty for AccelKind::bvh
    WideBvh bvh;                        ///< empty for the other kinds
    QuadricTree quadrics;
    UninitializedVector<TriangleSurface> surfaces; ///< by triangle_id, then of the quadrics, without normals
    AccelStatistics statistics;
};

} // namespace glint
