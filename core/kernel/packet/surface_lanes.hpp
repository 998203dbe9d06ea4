// What shading needs to know of the triangles and surfaces that a vector of rays has hit.
#pragma once

#include "kernel/kernel.hpp"
#include "kernel/packet/lanes.hpp"

namespace glint::HWY_NAMESPACE {

/// Reads the triangle of each lane. Neighbouring rays mostly hit the same triangle, or at least the same surface: one
/// look-up then does for all.
class TriangleLanes {
public:
    /// Reads triangle_id[0 .. lane_count) where lane_bits (not 0) says; other lanes repeat one of those.
    HWY_INLINE TriangleLanes(const KernelScene &scene, const uint32_t *triangle_id, uint32_t lane_bits) {
        const uint32_t first_id = triangle_id[lowest_bit(lane_bits)];
        const FloatMask same = hn::RebindMask(floats, hn::Eq(hn::Load(uints, triangle_id), hn::Set(uints, first_id)));
        const TriangleSurface &first = scene.geometry.surfaces[first_id];
        first_surface_ = first.surface;
        if ((bits_of(same) & lane_bits) == lane_bits) {
            normal_ = {splat(first.normal.x), splat(first.normal.y), splat(first.normal.z)};
            one_surface_ = true;
            surface_ = hn::Set(uints, first_surface_);
            return;
        }
        alignas(64) float x[lane_count], y[lane_count], z[lane_count];
        alignas(64) uint32_t surface[lane_count];
        uint32_t differing = 0;
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            const TriangleSurface &triangle =
                scene.geometry.surfaces[(lane_bits >> lane & 1) != 0 ? triangle_id[lane] : first_id];
            x[lane] = triangle.normal.x;
            y[lane] = triangle.normal.y;
            z[lane] = triangle.normal.z;
            surface[lane] = triangle.surface;
            differing |= triangle.surface ^ first_surface_;
        }
        normal_ = {hn::Load(floats, x), hn::Load(floats, y), hn::Load(floats, z)};
        surface_ = hn::Load(uints, surface);
        one_surface_ = differing == 0;
    }

    [[nodiscard]] HWY_INLINE const Points &normal() const { return normal_; }
    [[nodiscard]] HWY_INLINE Uints surface() const { return surface_; }
    [[nodiscard]] HWY_INLINE bool one_surface() const { return one_surface_; }
    [[nodiscard]] HWY_INLINE uint32_t first_surface() const { return first_surface_; }

private:
    Points normal_;
    Uints surface_;
    bool one_surface_;
    uint32_t first_surface_;
};

/// One number of every lane's surface. `surface` has lane_count elements; `one_surface` says that they are all equal.
template <typename Number>
HWY_INLINE Floats surface_number(const KernelScene &scene, const uint32_t *surface, bool one_surface, Number &&number) {
    if (one_surface) return splat(number(scene.surfaces[surface[0]]));
    alignas(64) float values[lane_count];
    for (uint32_t lane = 0; lane < lane_count; ++lane) values[lane] = number(scene.surfaces[surface[lane]]);
    return hn::Load(floats, values);
}

template <typename Color3>
HWY_INLINE Points surface_color(const KernelScene &scene, const uint32_t *surface, bool one_surface, Color3 &&color) {
    return {surface_number(scene, surface, one_surface, [&](const SurfaceShading &s) { return color(s).x; }),
            surface_number(scene, surface, one_surface, [&](const SurfaceShading &s) { return color(s).y; }),
            surface_number(scene, surface, one_surface, [&](const SurfaceShading &s) { return color(s).z; })};
}

} // namespace glint::HWY_NAMESPACE
