// A scene's materials and lights, arranged for the kernels.
#pragma once

#include <vector>

#include <glint/accel.hpp>

#include "kernel/kernel.hpp"
#include "render/light_tables.hpp"

namespace glint {

/// Owns what a KernelScene points to, except for the geometry, which the Accel owns. Knows nothing of where objects
/// stand.
class ShadingTables {
public:
    explicit ShadingTables(const Scene &scene);

    /// Of the scene that this was made of, or one that differs from it in where objects stand. Valid while this object
    /// and the Accel live.
    [[nodiscard]] KernelScene kernel_scene(const Accel &accel) const;

private:
    void add_object(const Object &object, float ambient, uint32_t first_triangle);

    std::vector<SurfaceShading> surfaces_;
    std::vector<std::vector<TriangleDetail>> details_;
    LightTables lights_;
};

} // namespace glint
