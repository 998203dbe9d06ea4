// An Accel as the kernels see it.
#pragma once

#include "accel/accel_impl.hpp"
#include "kernel/traverse.hpp"

namespace glint {

/// Valid while the Accel lives.
[[nodiscard]] inline GeometryView view_of(const Accel &accel) {
    const Accel::Impl &impl = accel.impl();
    const SharedParts &parts = *impl.shared;
    const QuadricTree &quadrics = *impl.quadrics;
    const InstanceTree &instances = impl.instances;
    Box bounds = parts.still.bounds();
    bounds.extend(quadrics.bounds);
    bounds.extend(instances.bounds);
    if (bounds.empty()) bounds.extend(glm::vec3(0.0f)); // of planes and the like alone
    return {parts.still.nodes(),
            parts.still.wide_nodes(),
            parts.still.leaf_words(),
            parts.surfaces.data(),
            impl.scene->triangle_count(),
            {quadrics.quadrics.data(), quadrics.nodes.data(), static_cast<uint32_t>(quadrics.quadrics.size()),
             quadrics.unbounded_count, quadrics.places.data()},
            {instances.instances.data(), instances.over.order.data(), instances.over.nodes.data(),
             parts.instance_of_surface.data(), static_cast<uint32_t>(instances.instances.size())},
            bounds};
}

} // namespace glint
