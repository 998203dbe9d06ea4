// Chooses how the rays of a group are traced. Through the kd-tree: all together, by the axis they follow, a quarter at
// a time, in step block by block, or one by one. Through the wide hierarchy: all together, or as streams.
#pragma once

#include "kernel/kernel.hpp"
#include "kernel/packet/block_stream.hpp"
#include "kernel/packet/block_trace.hpp"
#include "kernel/packet/group_trace.hpp"
#include "kernel/packet/instance_space.hpp"
#include "kernel/packet/quadric_trace.hpp"
#include "kernel/packet/rays_by_face.hpp"
#include "kernel/packet/stream_trace.hpp"

namespace glint::HWY_NAMESPACE {

/// A beam wider than this (by slope, from side to side) is not tried.
inline constexpr float widest_beam = 4.0f;
/// Fewer rays than this are not worth a beam.
inline constexpr uint32_t fewest_for_beam = 4;
/// Fewer rays than this are traced singly rather than in step.
inline constexpr uint32_t fewest_in_step = 3;
/// Blocks are asked together where a vector holds half of them.
inline constexpr bool has_block_streams = lane_count >= 8;
/// Steps that a beam may take before it is taken apart: a group's, a quarter's. Measured: see docs/performance.md.
inline constexpr uint32_t beam_budget[2] = {1600, 450};
/// The same of a group's beam in the wide hierarchy, where streams take over.
inline constexpr uint32_t bvh_beam_budget = 30;

/// After some failures only every eighth beam of a size is tried.
HWY_INLINE bool worth_trying(BeamHistory &history, int size) {
    return history.failures[size] < 6 || ++history.skipped[size] % 8 == 0;
}
HWY_INLINE void note(BeamHistory &history, int size, bool succeeded) {
    const int failures = history.failures[size] + (succeeded ? -2 : 2);
    history.failures[size] = static_cast<uint8_t>(failures < 0 ? 0 : failures > 8 ? 8 : failures);
}

/// Rays of a block that go the same way in step, others singly. All origins are read.
template <bool any_hit>
HWY_NOINLINE void trace_apart(const TraceQuestion &question, RayGroup &rays, RaySelection &selection, uint32_t block) {
    const uint32_t first_ray = block * block_size;
    for (uint32_t waiting = selection.blocks[block]; waiting != 0;) {
        const uint32_t lane = lowest_bit(waiting), i = first_ray + lane;
        const uint32_t together = waiting & rays_of_same_signs(rays, block, i);
        waiting &= ~together;
        uint32_t hits = 0;
        if (static_cast<uint32_t>(__builtin_popcount(together)) >= fewest_in_step) {
            BlockTrace<any_hit> trace(question, rays, block);
            hits = trace.run(together);
        } else {
            for (uint32_t rest = together; rest != 0; rest &= rest - 1) {
                const uint32_t l = lowest_bit(rest), r = first_ray + l;
                const Point3 org = {rays.org_x[r], rays.org_y[r], rays.org_z[r]};
                SingleTrace<any_hit> trace(question, rays, r, org);
                if (!trace.run()) continue;
                hits |= 1u << l;
                if constexpr (!any_hit) {
                    rays.t[r] = trace.t();
                    rays.triangle_id[r] = trace.triangle_id();
                }
            }
        }
        if constexpr (any_hit) selection.remove(first_ray, hits);
    }
}

HWY_INLINE float width_of(const Beam &beam) {
    return larger(beam.slope[0] + beam.slope[1], beam.slope[2] + beam.slope[3]);
}

/// What is known of a group's rays beforehand.
struct RayHint {
    bool is_full_tile = false;     ///< primary rays through all pixels of a tile
    const RayEnds *ends = nullptr; ///< of shadow rays, which mostly end on one surface
};

/// The beam around the selected rays; false where they do not go one way.
template <bool shares_origin, bool any_hit>
HWY_NOINLINE bool find_beam(const TraceQuestion &question, const RayGroup &rays, const RaySelection &selection,
                            const RayHint &hint, Beam &beam) {
    const Box &bounds = question.geometry.bounds;
    if (hint.is_full_tile) return make_tile_beam(rays, bounds, beam);
    if (hint.ends) return make_end_beam(rays, *hint.ends, bounds, beam);
    if (!make_beam<shares_origin>(rays, selection, bounds, beam)) return false;
    if (any_hit || rays.t[first_ray_of(selection)] < __FLT_MAX__) {
        beam.z_end = group_end<shares_origin>(rays, selection, beam);
    }
    return true;
}

enum class BeamOutcome {
    done,
    no_beam, ///< the rays do not go one way
    dropped, ///< it does not pay
};

/// Traces the selected rays as one beam through the kd-tree.
template <bool shares_origin, bool any_hit>
HWY_NOINLINE BeamOutcome trace_beam(const TraceQuestion &question, RayGroup &rays, RaySelection &selection, int size,
                                    BeamHistory &history, const RayHint &hint) {
    if (!worth_trying(history, size) || selection.count() < fewest_for_beam) return BeamOutcome::dropped;
    Beam beam;
    if (!find_beam<shares_origin, any_hit>(question, rays, selection, hint, beam) || width_of(beam) > widest_beam) {
        return BeamOutcome::no_beam;
    }
    const bool done =
        GroupTrace<shares_origin, any_hit>(question, rays, selection, beam, hint.ends).walk_kd_tree(beam_budget[size]);
    note(history, size, done);
    return done ? BeamOutcome::done : BeamOutcome::dropped;
}

/// Traces the selected rays as streams through the wide hierarchy.
template <bool shares_origin, bool any_hit> HWY_NOINLINE void trace_streams(const TraceQuestion &question,
                                                                            RayGroup &rays, RaySelection &selection,
                                                                            BeamHistory &history, const RayHint &hint) {
    Beam beam;
    bool has_beam = false;
    if (worth_trying(history, 1)) {
        has_beam =
            find_beam<shares_origin, any_hit>(question, rays, selection, hint, beam) && width_of(beam) <= widest_beam;
        note(history, 1, has_beam);
    }
    if (has_beam && worth_trying(history, 0)) {
        const bool done =
            GroupTrace<shares_origin, any_hit>(question, rays, selection, beam, hint.ends).walk_bvh(bvh_beam_budget);
        note(history, 0, done);
        if (done) return;
    }
    if constexpr (shares_origin && has_block_streams) {
        if (has_beam && beam.has_one_octant()) {
            BlockStream<any_hit>(question, rays, selection, beam, hint.ends).run();
            return;
        }
    }
    StreamTrace<shares_origin, any_hit>(question, rays, selection, has_beam ? &beam : nullptr).run();
}

/// The same a quarter of the group at a time, 2 x 2 blocks, or block by block.
template <bool shares_origin, bool any_hit> HWY_NOINLINE void
trace_quarters(const TraceQuestion &question, RayGroup &rays, RaySelection &selection, BeamHistory &history) {
    for (uint32_t quarter = 0; quarter < 4; ++quarter) {
        const uint32_t corner = quarter / 2 * 8 + quarter % 2 * 2;
        const uint32_t blocks[4] = {corner, corner + 1, corner + 4, corner + 5};
        RaySelection part{};
        for (const uint32_t block : blocks) part.blocks[block] = selection.blocks[block];
        if (part.empty()) continue;
        if (trace_beam<shares_origin, any_hit>(question, rays, part, 1, history, {}) != BeamOutcome::done) {
            for (const uint32_t block : blocks) {
                if constexpr (shares_origin) rays.spread_origin(block);
                trace_apart<any_hit>(question, rays, part, block);
            }
        }
        if constexpr (any_hit) {
            for (const uint32_t block : blocks) selection.blocks[block] = part.blocks[block];
        }
    }
}

/// Traces the selected rays through the scene's triangles.
template <bool shares_origin, bool any_hit>
HWY_NOINLINE void trace_triangles(const TraceQuestion &question, RayGroup &rays, RaySelection &selection,
                                  BeamHistory &history, const RayHint &hint) {
    if (selection.empty()) return;
    if (question.geometry.wide_nodes) {
        trace_streams<shares_origin, any_hit>(question, rays, selection, history, hint);
        return;
    }
    if (!question.geometry.nodes) return;
    const BeamOutcome outcome = trace_beam<shares_origin, any_hit>(question, rays, selection, 0, history, hint);
    if (outcome == BeamOutcome::done) return;
    if (outcome == BeamOutcome::dropped) {
        trace_quarters<shares_origin, any_hit>(question, rays, selection, history);
        return;
    }
    if constexpr (!shares_origin && !any_hit) {
        if (question.geometry.nodes[0].is_leaf()) {
            const Beam all = unbounded_beam(rays, selection, question.geometry.bounds);
            GroupTest<shares_origin, any_hit>(question, rays, selection, all, nullptr).visit_root_leaf();
            return;
        }
    }
    RaysByFace by(rays, selection);
    selection.clear();
    for (RaySelection &part : by.face) {
        if (part.empty()) continue;
        if (trace_beam<shares_origin, any_hit>(question, rays, part, 0, history, {}) != BeamOutcome::done) {
            trace_quarters<shares_origin, any_hit>(question, rays, part, history);
        }
        for (uint32_t block = 0; block < block_count; ++block) {
            selection.blocks[block] = static_cast<uint16_t>(selection.blocks[block] | part.blocks[block]);
        }
    }
}

/// The selected rays against what moves: against each instance whose box they meet in its own space, as if it were a
/// scene of its own.
HWY_NOINLINE void trace_instances(const TraceQuestion &question, RayGroup &rays, RaySelection &selection,
                                  BeamHistory &history, bool shares_origin, bool any_hit) {
    if (selection.empty()) return;
    const InstanceView &instances = question.geometry.instances;
    BoxTrace boxes(question.geometry.bounds, rays, selection, shares_origin, instance_slack);
    RayGroup own;
    boxes.walk(instances.nodes, [&](uint32_t i, const RaySelection &reach) {
        const Instance &instance = instances.all[instances.order[i]];
        take_inside(instance, rays, reach, shares_origin, own);
        const GeometryView inside = GeometryView::inside(instance);
        const TraceQuestion inner{inside};
        RaySelection asked = reach;
        if (any_hit) {
            if (shares_origin) {
                trace_triangles<true, true>(inner, own, asked, history, {});
            } else {
                trace_triangles<false, true>(inner, own, asked, history, {});
            }
            for (uint32_t b = 0; b < block_count; ++b) {
                const uint32_t hit = reach.blocks[b] & ~uint32_t{asked.blocks[b]};
                selection.blocks[b] = static_cast<uint16_t>(selection.blocks[b] & ~hit);
            }
        } else {
            if (shares_origin) {
                trace_triangles<true, false>(inner, own, asked, history, {});
            } else {
                trace_triangles<false, false>(inner, own, asked, history, {});
            }
            take_hits(instance, own, reach, rays);
        }
    });
}

/// Traces the selected rays. Those that are hit are deselected where any hit will do.
template <bool shares_origin, bool any_hit> HWY_INLINE void trace(const TraceQuestion &question, RayGroup &rays,
                                                                  RaySelection &selection, BeamHistory &history,
                                                                  const RayHint &hint = {}) {
    trace_triangles<shares_origin, any_hit>(question, rays, selection, history, hint);
    if (HWY_UNLIKELY(question.geometry.quadrics.count != 0)) {
        trace_quadrics<any_hit>(question, rays, selection, shares_origin);
    }
    if (HWY_UNLIKELY(question.geometry.instances.count != 0)) {
        trace_instances(question, rays, selection, history, shares_origin, any_hit);
    }
}

} // namespace glint::HWY_NAMESPACE
