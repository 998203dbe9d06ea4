// An Accel as the kernels see it.
#pragma once

#include "accel/accel_impl.hpp"
#include "kernel/traverse.hpp"

namespace glint {

/// Valid while the Accel lives.
[[nodiscard]] inline GeometryView view_of(const Accel &accel) {
    const Accel::Impl &impl = accel.impl();
    const bool is_bvh = impl.kind == AccelKind::bvh;
    Box bounds = is_bvh ? impl.bvh.bounds : impl.tree.bounds;
    bounds.extend(impl.quadrics.bounds);
    if (bounds.empty()) bounds.extend(glm::vec3(0.0f)); // of planes and the like alone
    return {is_bvh ? nullptr : impl.tree.nodes.data(),
            is_bvh ? impl.bvh.nodes.data() : nullptr,
            is_bvh ? impl.bvh.leaf_words.data() : impl.tree.leaf_words.data(),
            impl.surfaces.data(),
            impl.scene->triangle_count(),
            {impl.quadrics.quadrics.data(), impl.quadrics.nodes.data(),
             static_cast<uint32_t>(impl.quadrics.quadrics.size()), impl.quadrics.unbounded_count,
             impl.quadrics.places.data()},
            bounds};
}

} // namespace glint
