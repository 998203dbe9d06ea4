// Chooses how the rays of a group are traced: all together, block by block, or one by one.
#pragma once

#include "kernel/packet/single_trace.hpp"

namespace glint::HWY_NAMESPACE {

/// A beam wider than this (by slope, from side to side) is taken apart into blocks, a block's into rays: measured, see
/// docs/performance.md.
inline constexpr float widest_group = 0.35f;
inline constexpr float widest_block = 0.5f;
/// Fewer rays than this are not worth a beam.
inline constexpr uint32_t fewest_in_beam = 3;

template <bool shares_origin, bool any_hit>
HWY_NOINLINE void trace_singly(const TraceQuestion &question, RayGroup &rays, RaySelection &selection) {
    for (uint32_t block = 0; block < block_count; ++block) {
        for (uint32_t bits = selection.blocks[block]; bits != 0; bits &= bits - 1) {
            const uint32_t lane = lowest_bit(bits), i = block * block_size + lane;
            const Point3 org = shares_origin ? rays.shared_origin : Point3{rays.org_x[i], rays.org_y[i], rays.org_z[i]};
            SingleTrace<any_hit> trace(question, rays, i, org);
            if (!trace.run()) continue;
            if constexpr (any_hit) {
                selection.remove(block * block_size, 1u << lane);
            } else {
                rays.t[i] = trace.t();
                rays.triangle_id[i] = trace.triangle_id();
            }
        }
    }
}

HWY_INLINE float width_of(const Beam &beam) {
    return larger(beam.slope[0] + beam.slope[1], beam.slope[2] + beam.slope[3]);
}

/// Traces the selected rays. Those that are hit are deselected where any hit will do.
template <bool shares_origin, bool any_hit>
HWY_NOINLINE void trace(const TraceQuestion &question, RayGroup &rays, RaySelection &selection) {
    if (selection.empty()) return;
    Beam beam;
    const Box &bounds = question.geometry.bounds;
    if (selection.count() >= fewest_in_beam && make_beam<shares_origin>(rays, selection, bounds, beam) &&
        width_of(beam) <= widest_group) {
        GroupTrace<shares_origin, any_hit>(question, rays, selection, beam).run();
        return;
    }
    for (uint32_t block = 0; block < block_count; ++block) {
        if (selection.blocks[block] == 0) continue;
        RaySelection part{};
        part.blocks[block] = selection.blocks[block];
        if (static_cast<uint32_t>(__builtin_popcount(part.blocks[block])) >= fewest_in_beam &&
            make_beam<shares_origin>(rays, part, bounds, beam) && width_of(beam) <= widest_block) {
            GroupTrace<shares_origin, any_hit>(question, rays, part, beam).run();
        } else {
            trace_singly<shares_origin, any_hit>(question, rays, part);
        }
        if constexpr (any_hit) selection.blocks[block] = part.blocks[block];
    }
}

} // namespace glint::HWY_NAMESPACE
