// A scene's materials and lights, arranged for the kernels.
#pragma once

#include <vector>

#include <glint/accel.hpp>

#include "kernel/kernel.hpp"
#include "render/light_tables.hpp"

namespace glint {

/// Owns what a KernelScene points to, except for the geometry, which the Accel owns.
class ShadingTables {
public:
    explicit ShadingTables(const Accel &accel);

    /// Valid while this object and the Accel live.
    [[nodiscard]] KernelScene kernel_scene() const;

private:
    void add_object(const Object &object, uint32_t first_triangle);

    const Accel &accel_;
    std::vector<SurfaceShading> surfaces_;
    std::vector<std::vector<TriangleDetail>> details_;
    LightTables lights_;
};

} // namespace glint
