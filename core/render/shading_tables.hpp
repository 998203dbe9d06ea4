// A scene's materials and lights, arranged for the kernels.
#pragma once

#include <vector>

#include <glint/accel.hpp>

#include "kernel/kernel.hpp"

namespace glint {

/// Owns what a KernelScene points to, except for the geometry, which the Accel owns.
class ShadingTables {
public:
    explicit ShadingTables(const Accel &accel);

    /// Valid while this object and the Accel live.
    [[nodiscard]] KernelScene kernel_scene() const;

private:
    const Accel &accel_;
    std::vector<SurfaceShading> surfaces_;
    std::vector<LightShading> lights_;
};

} // namespace glint
