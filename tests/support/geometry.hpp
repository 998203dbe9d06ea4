// What the kernels trace against, from a public Accel.
#pragma once

#include "render/shading_tables.hpp"

namespace glint::test {

/// Valid while the accel lives.
[[nodiscard]] inline GeometryView geometry_of(const Accel &accel) {
    return ShadingTables(accel).kernel_scene().geometry;
}

} // namespace glint::test
