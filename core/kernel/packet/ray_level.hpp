// One level of a tile's ray trees: at most one ray a pixel.
#pragma once

#include "kernel/kernel.hpp"
#include "kernel/packet/trace.hpp"

namespace glint::HWY_NAMESPACE {

/// Rays, each in its pixel's place, and their shares in the pixels' colours.
struct RayLevel {
    RayGroup rays;
    alignas(64) float weight[group_size];
    alignas(64) uint32_t left_surface[group_size]; ///< of the triangle that a ray leaves
    RaySelection selection;
    bool is_even;   ///< of primary rays: they go through the same place of each pixel
    uint32_t depth; ///< recursive rays before these, themselves included
    alignas(64) uint32_t media[Media::most][group_size]; ///< that the rays run in, where the scene has refraction
};

/// Surfaces whose mirror rays are traced apart; what is left after so many goes together.
inline constexpr int most_surfaces_apart = 6;

/// The closest hits of all rays of a level. Rays that leave one surface go one way more often than others do, and make
/// better beams.
HWY_INLINE void trace_level(const GeometryView &geometry, RayLevel &level, BeamHistories &beams) {
    const TraceQuestion question{geometry};
    if (level.depth == 0) {
        trace<true, false>(question, level.rays, level.selection, beams.primary,
                           {.is_full_tile = level.is_even && level.selection.count() == group_size});
        return;
    }
    const int most_apart = geometry.wide_nodes ? 0 : most_surfaces_apart; // streams are the better the longer
    RaySelection waiting = level.selection;
    for (int apart = 0; !waiting.empty(); ++apart) {
        RaySelection together{};
        const Uints surface = hn::Set(uints, level.left_surface[first_ray_of(waiting)]);
        if (apart < most_apart) {
            for_each_vector(waiting, [&](uint32_t ray, uint32_t lanes) {
                const FloatMask same =
                    hn::RebindMask(floats, hn::Eq(hn::Load(uints, level.left_surface + ray), surface));
                together.add(ray, bits_of(same) & lanes);
            });
        } else {
            together = waiting;
        }
        for (uint32_t b = 0; b < block_count; ++b) {
            waiting.blocks[b] = static_cast<uint16_t>(waiting.blocks[b] & ~together.blocks[b]);
        }
        trace<false, false>(question, level.rays, together, beams.secondary);
    }
}

} // namespace glint::HWY_NAMESPACE
