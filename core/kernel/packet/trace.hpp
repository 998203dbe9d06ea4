// Chooses how the rays of a group are traced: all together, block by block, or one by one.
#pragma once

#include "kernel/packet/single_trace.hpp"

namespace glint::HWY_NAMESPACE {

/// A beam wider than this (by slope, from side to side) is not tried.
inline constexpr float widest_beam = 0.7f;
/// Fewer rays than this are not worth a beam.
inline constexpr uint32_t fewest_in_beam = 4;
/// Steps that a beam may take, by the rays in it: more than that and it is taken apart. Measured, see
/// docs/performance.md.
#ifndef BUDGET
#define BUDGET 6
#endif
inline constexpr uint32_t steps_per_ray = BUDGET, steps_at_least = 60;

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

/// Traces the selected rays as one beam; false where that does not pay.
template <bool shares_origin, bool any_hit>
HWY_NOINLINE bool trace_beam(const TraceQuestion &question, RayGroup &rays, RaySelection &selection) {
    const uint32_t count = selection.count();
    Beam beam;
    if (count < fewest_in_beam || !make_beam<shares_origin>(rays, selection, question.geometry.bounds, beam) ||
        width_of(beam) > widest_beam) {
        return false;
    }
    return GroupTrace<shares_origin, any_hit>(question, rays, selection, beam).run(steps_at_least + steps_per_ray * count);
}

/// Traces the selected rays. Those that are hit are deselected where any hit will do.
template <bool shares_origin, bool any_hit>
HWY_NOINLINE void trace(const TraceQuestion &question, RayGroup &rays, RaySelection &selection) {
    if (selection.empty() || trace_beam<shares_origin, any_hit>(question, rays, selection)) return;
    // Quarters of 2 x 2 blocks, then blocks, then rays.
    for (uint32_t quarter = 0; quarter < 4; ++quarter) {
        const uint32_t corner = quarter / 2 * 8 + quarter % 2 * 2;
        const uint32_t blocks[4] = {corner, corner + 1, corner + 4, corner + 5};
        RaySelection part{};
        for (const uint32_t block : blocks) part.blocks[block] = selection.blocks[block];
        if (part.empty()) continue;
        if (!trace_beam<shares_origin, any_hit>(question, rays, part)) {
            for (const uint32_t block : blocks) {
                if (part.blocks[block] == 0) continue;
                RaySelection one{};
                one.blocks[block] = part.blocks[block];
                if (!trace_beam<shares_origin, any_hit>(question, rays, one)) {
                    trace_singly<shares_origin, any_hit>(question, rays, one);
                }
                part.blocks[block] = one.blocks[block];
            }
        }
        if constexpr (any_hit) {
            for (const uint32_t block : blocks) selection.blocks[block] = part.blocks[block];
        }
    }
}

} // namespace glint::HWY_NAMESPACE
