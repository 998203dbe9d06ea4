// What the kernels trace against, from a public Accel.
#pragma once

#include "render/geometry_view.hpp"

namespace glint::test {

/// Valid while the accel lives.
[[nodiscard]] inline GeometryView geometry_of(const Accel &accel) {
    return view_of(accel);
}

} // namespace glint::test
