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

/// Colours of a tile's pixels.
struct alignas(64) TileColors {
    float red[group_size], green[group_size], blue[group_size];

    HWY_INLINE void clear() {
        for (uint32_t ray = 0; ray < group_size; ray += lane_count) {
            hn::Store(hn::Zero(floats), floats, red + ray);
            hn::Store(hn::Zero(floats), floats, green + ray);
            hn::Store(hn::Zero(floats), floats, blue + ray);
        }
    }
    /// Adds weight * color in the given lanes.
    HWY_INLINE void add(uint32_t ray, uint32_t lane_bits, Floats weight, const Points &color) {
        const FloatMask lanes = mask_of(lane_bits);
        add_row(red + ray, lanes, weight * color.x);
        add_row(green + ray, lanes, weight * color.y);
        add_row(blue + ray, lanes, weight * color.z);
    }
    [[nodiscard]] HWY_INLINE Points at(uint32_t ray) const {
        return {hn::Load(floats, red + ray), hn::Load(floats, green + ray), hn::Load(floats, blue + ray)};
    }
    HWY_INLINE void set(uint32_t ray, const Points &color) {
        hn::Store(color.x, floats, red + ray);
        hn::Store(color.y, floats, green + ray);
        hn::Store(color.z, floats, blue + ray);
    }

private:
    static HWY_INLINE void add_row(float *row, FloatMask lanes, Floats term) {
        const Floats old = hn::Load(floats, row);
        hn::Store(hn::IfThenElse(lanes, old + term, old), floats, row);
    }
};

/// Surface points of a level, and how they are lit.
struct alignas(64) SurfacePoints {
    float x[group_size], y[group_size], z[group_size];
    float normal_x[group_size], normal_y[group_size], normal_z[group_size]; ///< faces the viewer
    float scale[group_size];
    float weight[group_size]; ///< of local colour in the pixel
    uint32_t surface[group_size];
    RaySelection lit; ///< points that have local colour
    TileColors local; ///< so far, while there are lights to come

    [[nodiscard]] HWY_INLINE Points position(uint32_t ray) const {
        return {hn::Load(floats, x + ray), hn::Load(floats, y + ray), hn::Load(floats, z + ray)};
    }
    [[nodiscard]] HWY_INLINE Points normal(uint32_t ray) const {
        return {hn::Load(floats, normal_x + ray), hn::Load(floats, normal_y + ray), hn::Load(floats, normal_z + ray)};
    }
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
