// An Accel as the kernels see it.
#pragma once

#include "accel/accel_impl.hpp"
#include "kernel/traverse.hpp"

namespace glint {

/// Valid while the Accel lives.
[[nodiscard]] inline GeometryView view_of(const Accel &accel) {
    const Accel::Impl &impl = accel.impl();
    return {impl.tree.nodes.data(), impl.tree.leaf_words.data(), impl.surfaces.data(), impl.scene->triangle_count(),
            impl.tree.bounds};
}

} // namespace glint
