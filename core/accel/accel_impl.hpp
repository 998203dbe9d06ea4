// What stands behind the public Accel: read by the kernels.
#pragma once

#include <memory>
#include <vector>

#include <glint/accel.hpp>

#include "accel/instance_tree.hpp"
#include "accel/quadric_tree.hpp"
#include "accel/triangle_data.hpp"
#include "accel/triangle_tree.hpp"

namespace glint {

/// What scenes have in common that differ in where objects stand.
struct SharedParts {
    explicit SharedParts(const AccelOptions &options_) : options(options_) {}

    AccelOptions options;
    TriangleTree still;                            ///< over the triangles that never move
    std::vector<TriangleTree> meshes;              ///< of movers
    std::vector<Mover> movers;                     ///< meshes that move
    std::vector<uint32_t> instance_of_surface;     ///< number of the mover, or no_instance; empty without movers
    UninitializedVector<TriangleSurface> surfaces; ///< by triangle_id, then of the quadrics, without normals
    AccelStatistics statistics;
};

struct Accel::Impl {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const SharedParts> shared;
    std::shared_ptr<const QuadricTree> quadrics;
    InstanceTree instances;
    AccelStatistics statistics;
};

} // namespace glint
