// What a worker keeps of a tile between the stages of shading.
#pragma once

#include "kernel/packet/ray_level.hpp"

namespace glint::HWY_NAMESPACE {

/// Three numbers for each ray of a group.
struct alignas(64) PointRows {
    float x[group_size], y[group_size], z[group_size];

    [[nodiscard]] HWY_INLINE Points at(uint32_t ray) const {
        return {hn::Load(floats, x + ray), hn::Load(floats, y + ray), hn::Load(floats, z + ray)};
    }
    HWY_INLINE void set(uint32_t ray, const Points &p) {
        hn::Store(p.x, floats, x + ray);
        hn::Store(p.y, floats, y + ray);
        hn::Store(p.z, floats, z + ray);
    }
};

/// Colours of a tile's pixels: red, green, blue.
struct TileColors : PointRows {
    HWY_INLINE void clear() {
        const Floats zero = hn::Zero(floats);
        for (uint32_t ray = 0; ray < group_size; ray += lane_count) set(ray, {zero, zero, zero});
    }
    /// Adds weight * color in the given lanes.
    HWY_INLINE void add(uint32_t ray, uint32_t lane_bits, Floats weight, const Points &color) {
        const FloatMask lanes = mask_of(lane_bits);
        add_row(x + ray, lanes, weight * color.x);
        add_row(y + ray, lanes, weight * color.y);
        add_row(z + ray, lanes, weight * color.z);
    }

private:
    static HWY_INLINE void add_row(float *row, FloatMask lanes, Floats term) {
        const Floats old = hn::Load(floats, row);
        hn::Store(hn::IfThenElse(lanes, old + term, old), floats, row);
    }
};

/// Surface points of a level, and how they are lit.
struct alignas(64) SurfacePoints {
    PointRows position;
    PointRows normal; ///< faces the viewer
    float scale[group_size];
    float weight[group_size]; ///< of local colour in the pixel
    uint32_t surface[group_size];
    RaySelection lit; ///< points that have local colour
    TileColors local; ///< so far, while there are lights to come
};

/// Surface points of a level, where the scene has details.
struct SurfaceDetails {
    PointRows facet; ///< normals of the surface itself, while SurfacePoints' are for shading
    PointRows tint;
};

/// One light as a level's points see it, where lights are not all plain.
struct alignas(64) IncomingLights {
    PointRows to_light;         ///< unit vectors
    float strength[group_size]; ///< that the light's emission is multiplied by
};

/// Everything a tile works with; lies in the worker's memory.
struct TileWork {
    RayLevel *level, *next; ///< two of the levels below
    SurfacePoints points;
    RayGroup shadow;
    TileColors colors;
    RayLevel levels[2];
    BeamHistories *beams;
    // What most scenes never touch lies behind the rest.
    SurfaceDetails details;
    IncomingLights incoming;
};

} // namespace glint::HWY_NAMESPACE
