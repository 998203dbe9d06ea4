// What a tile of the Whitted renderer reads, in plain arrays: it is compiled for several instruction sets.
#pragma once

#include <cstdint>

#include <embree3/rtcore.h>

namespace glint::bench::embree {

/// The columns of the table of surfaces.
struct SurfaceColumns {
    const float *glow_r, *glow_g, *glow_b;          ///< without any light: ambient, a light's emission, the background
    const float *diffuse_r, *diffuse_g, *diffuse_b; ///< kd C
    const float *specular, *exponent;               ///< ks, ke
    const float *reflection, *transmission;         ///< kr, kt
};

struct WhittedLight {
    float x, y, z; ///< where shadow rays end
    float r, g, b;
    uint32_t ray_mask; ///< of shadow rays: everything but the light's own mesh
};

/// Surfaces are numbered as Embree's geometries: objects, then lights; the row after them is the background. Columns
/// are aligned to 64 bytes and have at least 16 entries.
struct WhittedScene {
    RTCScene scene;
    RTCIntersectContextFlags shadow_coherence; ///< Embree's hint for shadow rays
    RTCIntersectContextFlags mirror_coherence; ///< and for mirrored and transmitted ones; primary rays are coherent
    SurfaceColumns surfaces;
    uint32_t surface_count; ///< without the background
    uint32_t object_count;
    const WhittedLight *lights;
    uint32_t light_count;
};

/// A pinhole camera and where its picture goes.
struct WhittedFrame {
    float eye[3], corner[3]; ///< corner: from the eye to the window's top left
    float right[3], down[3]; ///< along the window's edges, in pixels
    uint32_t width_px, height_px;
    uint32_t max_depth;
    uint8_t *rgba8; ///< tight rows, top row first
};

/// Tiles are squares of this many pixels.
constexpr uint32_t tile_px = 16;

/// Rays of a tile that wait for one level of recursion, field by field. Where a surface sends rays both ways, ways of
/// less than 1/4096 of the pixel are not taken, so that no pixel ever has more than 4096 rays waiting.
constexpr uint32_t most_waiting = tile_px * tile_px * 4096;
constexpr uint32_t fields_waiting = 8; ///< origin, direction, weight, pixel
/// Floats that tracing a tile needs as scratch memory, aligned to 64 bytes: two levels, each field with room for a
/// packet after its end. Memory that is not used is never touched.
constexpr uint64_t scratch_floats = uint64_t{2} * fields_waiting * (most_waiting + 16);

/// Renders the tile whose first pixel is (x0, y0).
using TraceTile = void (*)(const WhittedScene &, const WhittedFrame &, uint32_t x0, uint32_t y0, float *scratch);

namespace sse4 {
void trace_tile(const WhittedScene &, const WhittedFrame &, uint32_t x0, uint32_t y0, float *scratch);
}
namespace avx2 {
void trace_tile(const WhittedScene &, const WhittedFrame &, uint32_t x0, uint32_t y0, float *scratch);
}
namespace avx512 {
void trace_tile(const WhittedScene &, const WhittedFrame &, uint32_t x0, uint32_t y0, float *scratch);
}

} // namespace glint::bench::embree
