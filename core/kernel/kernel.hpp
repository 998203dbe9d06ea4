// The door to what is compiled per instruction set: a kernel renders a whole tile, from camera rays to bytes, and
// answers whole batches of rays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glint/isa.hpp>
#include <glint/ray_query.hpp>
#include <glint/scene.hpp>

#include "kernel/samples.hpp"
#include "kernel/traverse.hpp"

namespace glint {

/// A triangle as interpolation over it needs it: what its corners have.
struct TriangleDetail {
    TriangleCorners corners;
    glm::vec3 normals[3]; ///< unit; all zero where the triangle is flat
    glm::vec2 texcoords[3];
};

/// A surface as shading needs it; products of a scene's constants are taken once.
struct SurfaceShading {
    bool is_light;                 ///< shows `emission`, whatever else is set
    bool is_smooth;                ///< some of its triangles have normals at their corners
    Color emission;                ///< I * (r, g, b) of a light
    Color ambient_color;           ///< ka * Ia * C
    Color diffuse_color;           ///< kd * C
    float specular;                ///< ks
    float exponent;                ///< ke
    float reflection;              ///< kr
    float transmission;            ///< kt
    float replaced;                ///< 1 where kr and kt take the place of local colour, 0 where they add to it
    float ior;                     ///< of what the surface encloses
    Color highlight_color;         ///< of the highlight, besides the light's
    const Texture *texture;        ///< or nullptr
    const TriangleDetail *details; ///< of its triangles, or nullptr where they are plain
    uint32_t first_triangle;       ///< the triangle_id of the first of them
};

/// A mesh light's triangles, for choosing places on them.
struct LightArea {
    const Mesh *mesh;
    const float *cumulative; ///< share of the area up to and including each triangle; the last is 1
};

/// A place that light comes from, or several of one light that are chosen at random.
struct LightShading {
    Light::Kind kind;
    bool has_falloff;
    Point position;   ///< where it has one place
    Vector direction; ///< of directional and spot lights: where they shine, unit length
    Color emission;   ///< L; of one of several places, its share
    /// Its own shape, which does not block its shadow rays: so many triangles or quadrics from this one on.
    uint32_t first_triangle, triangle_count;
    float cos_outer, inverse_fade; ///< of a spot: no light at that cosine, full light 1 / inverse_fade above it
    const LightArea *area;         ///< places are chosen at random here; or nullptr
    uint32_t sample, sample_count; ///< which of how many such places
};

/// Everything a kernel reads, by pointers that the render's caller keeps alive. The flags say that some surface or
/// light needs more than triangles in one colour lit from fixed places do.
struct KernelScene {
    GeometryView geometry;
    const SurfaceShading *surfaces;
    const LightShading *lights;
    uint32_t light_count;
    uint32_t seed;
    Color background;
    bool may_branch;     ///< some surface both mirrors and transmits, or comes to
    bool has_additions;  ///< some surface adds mirrored light to its own
    bool has_refraction; ///< some surface encloses something with an index of refraction
    bool has_details;    ///< some surface is smooth or textured
    /// All lights shine the same in all directions from one place, nothing lets them through, and no surface has
    /// details or coloured highlights.
    bool is_lit_plainly;
    bool fresnel, shadows_through_glass;
    float offset_floor; ///< least length scale for moving ray origins off surfaces, in scene units
};

/// Surfaces that a ray is inside of, the innermost first, no_surface behind the last.
struct Media {
    static constexpr int most = 4;
    uint32_t inside[most];
};
inline constexpr uint32_t no_surface = UINT32_MAX;

/// One picture to be rendered.
struct KernelFrame {
    Camera camera;
    uint32_t width_px, height_px;
    uint32_t max_depth;
    uint8_t *rgba8;                                   ///< R, G, B, A, the top row first
    float *radiance;                                  ///< R, G, B, before the tone curve; may be nullptr
    size_t rgba8_stride_bytes, radiance_stride_bytes; ///< from a row to the next
    SampleGrid samples;
    float tone_scale; ///< 0 = no tone curve
    bool to_srgb;     ///< whether the bytes are sRGB's
    Media eye_media;  ///< that the camera stands in
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
    Media media;            ///< that it runs in; told only in scenes with refraction
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
