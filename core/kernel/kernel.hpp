// The door to what is compiled per instruction set: a kernel renders a whole tile, from camera rays to bytes, and
// answers whole batches of rays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glint/isa.hpp>
#include <glint/ray_query.hpp>
#include <glint/scene.hpp>

#include "kernel/traverse.hpp"

namespace glint {

/// A surface as shading needs it; products of a scene's constants are taken once.
struct SurfaceShading {
    bool is_light;       ///< shows `emission`, whatever else is set
    Color emission;      ///< I * (r, g, b) of a light
    Color ambient_color; ///< ka * Ia * C
    Color diffuse_color; ///< kd * C
    float specular;      ///< ks
    float exponent;      ///< ke
    float reflection;    ///< kr
    float transmission;  ///< kt
};

/// A light as shading needs it.
struct LightShading {
    Point position;
    Color emission; ///< L
    /// Its own mesh, which does not block its shadow rays: so many triangles from this one on.
    uint32_t first_triangle, triangle_count;
};

/// Everything a kernel reads, by pointers that the render's caller keeps alive.
struct KernelScene {
    GeometryView geometry;
    const SurfaceShading *surfaces;
    const LightShading *lights;
    uint32_t light_count;
    Color background;
    bool may_branch;    ///< some surface both mirrors and transmits
    float offset_floor; ///< least length scale for moving ray origins off surfaces, in scene units
};

/// One picture to be rendered.
struct KernelFrame {
    Camera camera;
    uint32_t width_px, height_px;
    uint32_t max_depth;
    uint8_t *rgba8;  ///< tight rows, top row first
    float *radiance; ///< R, G, B; may be nullptr
};

/// Pixels with x0 <= x < x1 and y0 <= y < y1.
struct Tile {
    uint32_t x0, y0, x1, y1;
};

struct RayCounts {
    uint64_t primary = 0, shadow = 0, secondary = 0;
};

/// A ray still to be traced, and its share in the pixel's colour.
struct PendingRay {
    Ray ray;
    uint32_t depth; ///< recursive rays before it, itself included
    float weight;
    uint32_t left_triangle; ///< that it leaves from; no_triangle for a primary ray
};

/// How beams of rays fared lately, by their size, so that scenes that are too fine for beams do not pay for trying.
/// Decides how rays are traced, never what they hit.
struct BeamHistory {
    /// Of groups; of quarters of groups or, in the wide hierarchy, of finding a beam around a group at all.
    uint8_t failures[2], skipped[2];
};
struct BeamHistories {
    BeamHistory primary, shadow, secondary;
};

/// Memory that a worker reuses from tile to tile.
struct KernelScratch {
    std::vector<PendingRay> pending;
    std::byte *memory = nullptr; ///< Kernel::scratch_bytes() of it, aligned to scratch_alignment
    RayCounts rays;
    BeamHistories beams{};
};

inline constexpr size_t scratch_alignment = 64;

using ScratchBytes = size_t (*)(const KernelScene &, const KernelFrame &);
using RenderTile = void (*)(const KernelScene &, const KernelFrame &, Tile, KernelScratch &);
using ClosestHits = void (*)(const GeometryView &, const RayBatch &, const HitBatch &);
using AnyHits = void (*)(const GeometryView &, const RayBatch &, uint8_t *occluded);

/// What is compiled per instruction set.
struct Kernel {
    Isa isa;
    ScratchBytes scratch_bytes; ///< of KernelScratch::memory for tiles of this picture
    RenderTile render_tile;
    ClosestHits closest_hits;
    AnyHits any_hits;
};

/// The kernel that is written for clarity, one ray at a time. The others are tested against it, bit by bit.
extern const Kernel scalar_kernel;
/// Kernels on packets of rays, where they were built in: see packet/.
extern const Kernel sse4_kernel, avx2_kernel, avx512_kernel, neon_kernel, wasm_kernel;

/// The kernel for an available instruction set; the scalar one for any other.
[[nodiscard]] const Kernel &kernel_for(Isa isa);

} // namespace glint
