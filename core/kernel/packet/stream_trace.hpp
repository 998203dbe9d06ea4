// Rays that go different ways through the wide hierarchy, but in the same octant of directions: a node is fetched once
// for all rays that enter it, and each child gets the list of the rays that enter that child (Barringer &
// Akenine-Moller 2014, "Dynamic ray stream traversal"). Lists that got short are finished ray by ray.
#pragma once

#include "kernel/packet/leaf_lists.hpp"
#include "kernel/packet/leaf_occluders.hpp"
#include "kernel/packet/stream_rays.hpp"

namespace glint::HWY_NAMESPACE {

/// Fewer rays than this are not worth a list. Measured: see docs/performance.md.
inline constexpr uint32_t fewest_in_stream = 4;
/// Fewer rays than this ask a node's children at once, not the beam around all rays first.
inline constexpr uint32_t fewest_to_ask_beam = 16;
/// Fewer rays than this are not worth working out what a leaf's triangles have for all rays.
inline constexpr uint32_t fewest_to_prepare_leaf = 2;
/// Lists that wait: those of a node's children at every level.
inline constexpr uint32_t most_lists = (WideNode::width - 1) * max_bvh_depth + WideNode::width;

template <bool shares_origin, bool any_hit> class StreamTrace {
public:
    /// `beam` is around all selected rays, or nullptr.
    HWY_INLINE StreamTrace(const TraceQuestion &question, RayGroup &rays, RaySelection &selection, const Beam *beam)
        : question_(question), rays_(rays), selection_(selection), beam_(beam), prepared_(question, rays) {}

    /// Traces the selected rays. Those that are hit are deselected where any hit will do.
    HWY_NOINLINE void run() {
        const bool one_octant = prepare() == 0;
        uint32_t sorted[group_size + lane_count];
        uint32_t starts[9] = {};
        if (one_octant) {
            for_each_ray(selection_, [&](uint32_t ray) { sorted[starts[0]++] = ray; });
        } else {
            for_each_ray(selection_, [&](uint32_t ray) { ++starts[prepared_.octant(ray) + 1]; });
            for (uint32_t octant = 0; octant < 8; ++octant) starts[octant + 1] += starts[octant];
            for_each_ray(selection_, [&](uint32_t ray) { sorted[starts[prepared_.octant(ray)]++] = ray; });
        }
        for (uint32_t i = 0, begin = 0; i < 8; begin = starts[i++]) {
            if (starts[i] > begin) walk(ChildLink::node(0), sorted + begin, starts[i] - begin);
            if (one_octant) break;
        }
    }

    /// For rays of one octant that are picked elsewhere: prepare(), then for parts of the tree enter() and walk().
    /// Returns in which axes' signs they differ.
    HWY_INLINE uint32_t prepare() { return prepared_.prepare(selection_); }
    /// Appends the rays of a block that enter a node's child; returns how many. Up to a vector more is written.
    HWY_INLINE uint32_t enter(uint32_t block, const WideNode &node, uint32_t child, uint32_t *to) {
        return prepared_.template enter<any_hit>(selection_, block, node, child, to);
    }

    /// Rays of one octant through all that a link leads to. Up to a vector more is read.
    HWY_NOINLINE void walk(ChildLink root, const uint32_t *sorted, uint32_t count) {
        const WideRows rows(prepared_.octant(sorted[0]));
        Pending stack[most_lists];
        uint32_t pending = 0;
        for (uint32_t i = 0; i < count; i += lane_count) hn::StoreU(hn::LoadU(uints, sorted + i), uints, ids_ + i);
        stack[pending++] = {root.word(), 0, static_cast<uint16_t>(count), 0.0f, hits_};
        while (pending > 0) {
            Pending now = stack[--pending];
            if (pending > 0) prefetch(question_.geometry, ChildLink(stack[pending - 1].link));
            if (now.hits != hits_) now.count = static_cast<uint16_t>(still_looking(now));
            if (now.count == 0) continue;
            const ChildLink link(now.link);
            uint32_t *const ids = ids_ + now.first;
            if (link.is_leaf()) {
                visit_leaf(link, ids, now.count);
            } else if (now.count < fewest_in_stream || now.first + (1 + WideNode::width) * now.count > arena_size) {
                for (uint32_t i = 0; i < now.count; ++i) finish(rows, ids[i], link);
            } else {
                pending = visit_node(rows, link, now, stack, pending);
            }
        }
    }

    /// That have been found.
    [[nodiscard]] HWY_INLINE uint32_t hits() const { return hits_; }

private:
    struct Pending {
        uint32_t link;
        uint16_t first, count; ///< its rays in ids_
        float begin;           ///< none of them enters before
        uint32_t hits;         ///< that had been found by then
    };
    static constexpr uint32_t arena_size = 8192; ///< links that do not fit are followed ray by ray

    /// Drops the rays that have found something nearer by now; returns how many are left.
    HWY_INLINE uint32_t still_looking(const Pending &now) {
        uint32_t *const ids = ids_ + now.first;
        uint32_t count = 0;
        for (uint32_t i = 0; i < now.count; ++i) {
            const uint32_t ray = ids[i];
            ids[count] = ray;
            count += prepared_.end(ray) >= now.begin ? 1u : 0u;
        }
        return count;
    }

    /// Copies those rays whose flags have the bit; returns how many. Up to a vector behind them is written.
    static HWY_INLINE uint32_t pick(const uint32_t *flags, uint32_t bit, const uint32_t *rays, uint32_t count,
                                    uint32_t *to) {
        uint32_t picked = 0;
        for (uint32_t i = 0; i < count; i += lane_count) {
            const uint32_t valid = count - i >= lane_count ? all_lanes : ~(~0u << (count - i));
            const uint32_t chosen =
                bits_of(uints, hn::TestBit(hn::Load(uints, flags + i), hn::Set(uints, bit))) & valid;
            picked += put_chosen(hn::LoadU(uints, rays + i), chosen, to + picked);
        }
        return picked;
    }

    HWY_INLINE uint32_t visit_node(const WideRows &rows, ChildLink link, const Pending &now, Pending *stack,
                                   uint32_t pending) {
        const WideNode &node = question_.geometry.wide_nodes[link.number()];
        if (beam_ && now.count >= fewest_to_ask_beam) {
            alignas(32) float begins[WideNode::width];
            const uint32_t reached = children_in_beam(*beam_, node, begins);
            if (reached == 0) return pending;
            if ((reached & (reached - 1)) == 0) {
                stack[pending] = now;
                stack[pending].link = node.child[lowest_bit(reached)];
                return pending + 1;
            }
        }
        uint32_t *const ids = ids_ + now.first;
        const typename StreamRays<shares_origin>::Node seen(prepared_, node, rows, prepared_.octant(ids[0]));
        alignas(64) uint32_t entered[group_size + lane_count];
        uint32_t any = 0;
        alignas(32) float begins[WideNode::width]; // the least of all rays
        NarrowFloats first_begin[WideNode::width / narrow_lanes];
        for (NarrowFloats &b : first_begin) b = narrow_splat(any_hit ? 0.0f : __builtin_inff());
        for (uint32_t i = 0; i < now.count; ++i) {
            const uint32_t ray = ids[i];
            uint32_t bits = 0;
            for (uint32_t c = 0; c < WideNode::width; c += narrow_lanes) {
                const auto ways = seen.ways_of(ray, c);
                if constexpr (!any_hit) { // which else are as good in any order
                    NarrowFloats &least = first_begin[c / narrow_lanes];
                    least = hn::Min(least, hn::IfThenElse(ways.exist, ways.begin, least));
                }
                bits |= bits_of(narrow_floats, ways.exist) << c;
            }
            entered[i] = bits;
            any |= bits;
        }
        if (any == 0) return pending;
        for (uint32_t c = 0; c < WideNode::width; c += narrow_lanes) {
            hn::Store(first_begin[c / narrow_lanes], narrow_floats, begins + c);
        }

        uint32_t order[WideNode::width];
        const uint32_t used = far_first(begins, any, order);
        prefetch(question_.geometry, ChildLink(node.child[order[used - 1]])); // is next
        // The last list takes the place of the one that was read.
        uint32_t first = now.first + uint32_t{now.count};
        for (uint32_t u = 0; u < used; ++u) {
            const uint32_t c = order[u];
            const uint32_t count = pick(entered, 1u << c, ids, now.count, ids_ + first);
            stack[pending++] = {node.child[c], static_cast<uint16_t>(first), static_cast<uint16_t>(count), begins[c],
                                hits_};
            first += count;
        }
        return pending;
    }

    HWY_NOINLINE void visit_leaf(ChildLink link, const uint32_t *ids, uint32_t count) {
        if (count < fewest_to_prepare_leaf) {
            for (uint32_t i = 0; i < count; ++i) {
                const uint32_t ray = ids[i];
                if (any_hit && prepared_.end(ray) < 0.0f) continue;
                float t = rays_.t[ray];
                uint32_t id = rays_.triangle_id[ray];
                if (hit_leaf<any_hit>(question_, link.number(), link.reference_count(), prepared_.leaf_ray(ray), t,
                                      id)) {
                    take(ray, t, id);
                }
            }
            return;
        }
        const uint32_t references = link.reference_count();
        const uint32_t *words = question_.geometry.leaf_words + words_per_reference * size_t{link.number()};
        for (uint32_t first = 0; first < references; first += narrow_lanes) {
            if constexpr (shares_origin && any_hit) {
                const LeafOccluders leaf(question_, words, references, first, rays_.shared_origin,
                                         prepared_.dir_reach());
                for_each_looking(ids, count, [&](uint32_t ray, const Point3 &dir, float &t, uint32_t &) {
                    return leaf.block(dir, rays_.left[ray], t);
                });
            } else if constexpr (shares_origin) {
                const LeafFromPoint leaf(words, references, first, rays_.shared_origin, prepared_.dir_reach());
                for_each_looking(ids, count, [&](uint32_t ray, const Point3 &dir, float &t, uint32_t &id) {
                    return leaf.hit(dir, prepared_.dir_reach(ray), rays_.left[ray], t, id);
                });
            } else {
                LeafFromAnywhere leaf(words, references, first, prepared_.dir_reach());
                if constexpr (any_hit) leaf.passes = leaf.passed_by(question_);
                for_each_looking(ids, count, [&](uint32_t ray, const Point3 &dir, float &t, uint32_t &id) {
                    return leaf.template hit<any_hit>(prepared_.org(ray), dir, prepared_.dir_reach(ray),
                                                      rays_.left[ray], t, id);
                });
            }
        }
    }

    /// Takes what hit(ray, dir, t, id) finds, which says whether it did and lowers t.
    template <typename Hit> HWY_INLINE void for_each_looking(const uint32_t *ids, uint32_t count, Hit &&hit) {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t ray = ids[i];
            if (any_hit && prepared_.end(ray) < 0.0f) continue;
            float t = rays_.t[ray];
            uint32_t id = rays_.triangle_id[ray];
            if (hit(ray, prepared_.dir(ray), t, id)) take(ray, t, id);
        }
    }

    HWY_INLINE void take(uint32_t ray, float t, uint32_t id) {
        ++hits_;
        if constexpr (any_hit) {
            selection_.remove(ray / block_size * block_size, 1u << (ray % block_size));
            prepared_.set_done(ray);
        } else {
            rays_.t[ray] = t;
            rays_.triangle_id[ray] = id;
            prepared_.set_end(ray, t);
        }
    }

    /// One ray through all that a link leads to.
    HWY_NOINLINE void finish(const WideRows &rows, uint32_t ray, ChildLink link) {
        if (any_hit && prepared_.end(ray) < 0.0f) return;
        float t = rays_.t[ray];
        uint32_t id = rays_.triangle_id[ray];
        if (walk_wide<any_hit>(question_, prepared_.slabs(ray), rows, link, prepared_.unit(ray),
                               prepared_.leaf_ray(ray), t, id)) {
            take(ray, t, id);
        }
    }

    const TraceQuestion &question_;
    RayGroup &rays_;
    RaySelection &selection_;
    const Beam *beam_;
    uint32_t hits_ = 0;
    StreamRays<shares_origin> prepared_;
    alignas(64) uint32_t ids_[arena_size + 32];
};

} // namespace glint::HWY_NAMESPACE
