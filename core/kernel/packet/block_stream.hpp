// Blocks of rays from one point through the wide hierarchy: a node is fetched once for all blocks whose own beams reach
// it, and each child gets the set of the blocks that reach that child. As stream_trace.hpp does it with rays; but here
// a box is asked once for sixteen of them, and a triangle meets them all at once.
#pragma once

#include "kernel/packet/leaf_lists.hpp"
#include "kernel/packet/stream_trace.hpp"

namespace glint::HWY_NAMESPACE {

/// What is smaller than so many blocks, as it is seen, is left to single rays.
inline constexpr float small_to_block = 6.0f;

template <bool any_hit> class BlockStream : private GroupTest<true, any_hit> {
    using Test = GroupTest<true, any_hit>;
    using Test::beam_, Test::blocks_, Test::dirty_blocks_, Test::question_, Test::rays_, Test::selection_;

public:
    HWY_INLINE BlockStream(const TraceQuestion &question, RayGroup &rays, RaySelection &selection, const Beam &beam,
                           const RayEnds *ends)
        : Test(question, rays, selection, beam, ends), streams_(question, rays, selection, nullptr) {}

    /// Traces the selected rays, whose directions should have the same signs. Those that are hit are deselected where
    /// any hit will do.
    HWY_INLINE void run() {
        this->make_block_beams();
        const uint32_t all = measure_blocks();
        uint32_t pending = 0;
        stack_[pending++] = {0.0f, ChildLink::node(0).word(), static_cast<uint16_t>(all), false, 0};
        while (pending > 0) {
            const Pending now = stack_[--pending];
            if (pending > 0) prefetch(question_.geometry, ChildLink(stack_[pending - 1].link));
            const uint32_t blocks = now.blocks & blocks_beyond(now.begin);
            if (blocks == 0) continue;
            const ChildLink link(now.link);
            if (now.is_small) {
                if (!streams_ready_ && streams_.prepare() != 0) {
                    streams_.run();
                    return;
                }
                streams_ready_ = true;
                trace_rays(now, blocks);
            } else if (link.is_leaf()) {
                visit_leaf(link, blocks);
            } else {
                pending = visit_node(link.number(), blocks, pending);
            }
        }
    }

private:
    struct Pending {
        float begin; ///< how far behind the beam's own begin it begins
        uint32_t link;
        uint16_t blocks; ///< that reach it
        bool is_small;   ///< left to single rays
        uint32_t box;    ///< whose child it is, times width, and which
    };
    static constexpr uint32_t most_pending = (WideNode::width - 1) * max_bvh_depth + WideNode::width;

    /// Returns which blocks have rays, and finds out how large they are across the beam.
    HWY_INLINE uint32_t measure_blocks() {
        Floats sum = hn::Zero(floats);
        uint32_t all = 0;
        for (uint32_t b = 0; b < block_count; b += lane_count) {
            const auto width = [&](int side) {
                return hn::Load(floats, blocks_.slope[side] + b) + hn::Load(floats, blocks_.slope[side + 1] + b);
            };
            sum = sum + width(0) * width(2); // blocks without rays have no width
        }
        for (uint32_t block = 0; block < block_count; ++block) {
            all |= (selection_.blocks[block] != 0 ? 1u : 0u) << block;
        }
        block_area_ = hn::GetLane(hn::SumOfLanes(floats, sum)) / static_cast<float>(__builtin_popcount(all));
        return all;
    }

    /// Children whose boxes are so small, as they are seen, that single rays are better.
    HWY_INLINE uint32_t small_children(const WideNode &node, const float *begins) const {
        const BeamAxes &axes = beam_.axes;
        uint32_t small = 0;
        for (uint32_t i = 0; i < WideNode::width; i += narrow_lanes) {
            const auto extent = [&](int axis) {
                return hn::Load(narrow_floats, node.bounds[static_cast<uint32_t>(axis) + WideNode::highest] + i) -
                       hn::Load(narrow_floats, node.bounds[static_cast<uint32_t>(axis) + WideNode::lowest] + i);
            };
            const auto depth = hn::Load(narrow_floats, begins + i);
            const auto area = narrow_splat(small_to_block * block_area_) * (depth * depth);
            small |= bits_of(narrow_floats, hn::Lt(extent(axes.u) * extent(axes.v), area)) << i;
        }
        return small;
    }

    /// Goes on with the rays themselves.
    HWY_INLINE void trace_rays(const Pending &now, uint32_t blocks) {
        prefetch(question_.geometry, ChildLink(now.link));
        const WideNode &node = question_.geometry.wide_nodes[now.box / WideNode::width];
        uint32_t rays[group_size + lane_count], count = 0;
        for (uint32_t rest = blocks; rest != 0; rest &= rest - 1) {
            count += streams_.enter(lowest_bit(rest), node, now.box % WideNode::width, rays + count);
        }
        if (count == 0) return;
        const uint32_t hits = streams_.hits();
        streams_.walk(ChildLink(now.link), rays, count);
        if (streams_.hits() == hits) return;
        for (uint32_t rest = blocks; rest != 0; rest &= rest - 1) this->update_end(lowest_bit(rest));
    }

    /// Blocks with a ray that goes as far as that.
    HWY_INLINE uint32_t blocks_beyond(float begin) const {
        const Floats least = splat((begin - 2.0f * beam_.slack) + beam_.z_begin);
        uint32_t beyond = 0;
        for (uint32_t b = 0; b < block_count; b += lane_count) {
            beyond |= bits_of(hn::Le(least, hn::Load(floats, blocks_.z_end + b))) << b;
        }
        return beyond;
    }

    HWY_INLINE uint32_t visit_node(uint32_t number, uint32_t blocks, uint32_t pending) {
        const WideNode &node = question_.geometry.wide_nodes[number];
        alignas(32) float begins[WideNode::width];
        uint32_t reached = children_in_beam(beam_, node, begins);
        const uint32_t small = small_children(node, begins);
        const auto push = [&](uint32_t child, uint32_t reached_by) {
            stack_[pending] = {begins[child], node.child[child], static_cast<uint16_t>(reached_by),
                               (small >> child & 1) != 0, number * WideNode::width + child};
            pending += reached_by != 0 ? 1u : 0u; // nothing foretells whether a branch would be taken
        };
        if constexpr (any_hit) {
            for (; reached != 0; reached &= reached - 1) {
                const uint32_t child = lowest_bit(reached);
                push(child, blocks_that_reach(node, child) & blocks);
            }
        } else {
            uint32_t order[WideNode::width];
            const uint32_t count = far_first(begins, reached, order);
            for (uint32_t i = 0; i < count; ++i) push(order[i], blocks_that_reach(node, order[i]) & blocks);
        }
        return pending;
    }

    /// children_in_beam() for all blocks and one child.
    HWY_INLINE uint32_t blocks_that_reach(const WideNode &node, uint32_t child) const {
        const BeamAxes &axes = beam_.axes;
        const auto lowest = [&](int axis) {
            return node.bounds[static_cast<uint32_t>(axis) + WideNode::lowest][child];
        };
        const auto highest = [&](int axis) {
            return node.bounds[static_cast<uint32_t>(axis) + WideNode::highest][child];
        };
        const bool upward = axes.sign > 0.0f;
        const float z_lo = ((upward ? lowest(axes.z) : highest(axes.z)) - axes.base_z()) * axes.sign;
        const float z_hi = ((upward ? highest(axes.z) : lowest(axes.z)) - axes.base_z()) * axes.sign;
        const float across[4] = {axes.base_u() - highest(axes.u), lowest(axes.u) - axes.base_u(),
                                 axes.base_v() - highest(axes.v), lowest(axes.v) - axes.base_v()};
        const Floats from = splat(larger(z_lo, beam_.z_begin)), end = splat(z_hi), room = splat(2.0f * beam_.slack);
        uint32_t reach = 0;
        for (uint32_t b = 0; b < block_count; b += lane_count) {
            const Floats to = hn::Min(end, hn::Load(floats, blocks_.z_end + b));
            FloatMask inside = hn::Le(from, to + room);
            for (int side = 0; side < 4; ++side) {
                const Floats slope = hn::Load(floats, blocks_.slope[side] + b);
                const Floats most = hn::Load(floats, blocks_.offset[side] + b) + hn::Max(slope * from, slope * to);
                inside = hn::And(inside, hn::Le(splat(across[side]), most));
            }
            reach |= bits_of(inside) << b;
        }
        return reach;
    }

    HWY_INLINE void visit_leaf(ChildLink link, uint32_t blocks) {
        const uint32_t count = link.reference_count();
        const uint32_t *words = question_.geometry.leaf_words + words_per_reference * size_t{link.number()};
        dirty_blocks_ = 0;
        for (uint32_t first = 0; first < count; first += narrow_lanes) {
            const uint32_t valid = (1u << smaller(count - first, narrow_lanes)) - 1;
            const BeamCorners corners(beam_.axes, words, count, first);
            uint32_t entered = triangles_in_beam(beam_, corners) & valid;
            if (entered == 0) continue;
            LeafFromPoint leaf(words, count, first, rays_.shared_origin, beam_.dir_reach);
            if constexpr (any_hit) entered &= ~leaf.passed_by(question_);
            const LeafFromPoint::Rows rows = leaf.rows();
            for (; entered != 0; entered &= entered - 1) {
                const uint32_t i = lowest_bit(entered);
                float triangle[9];
                for (uint32_t row = 0; row < 9; ++row) {
                    __builtin_memcpy(&triangle[row], words + row * count + first + i, sizeof(float));
                }
                test(leaf, rows, i, blocks_.entered_by(beam_.axes, triangle) & blocks);
            }
        }
        for (; dirty_blocks_ != 0; dirty_blocks_ &= dirty_blocks_ - 1) this->update_end(lowest_bit(dirty_blocks_));
    }

    /// A triangle of a leaf against the rays of some blocks.
    HWY_INLINE void test(const LeafFromPoint &leaf, const LeafFromPoint::Rows &rows, uint32_t i, uint32_t blocks) {
        const auto point = [i](const float(&row)[3][narrow_lanes]) {
            return splat(Point3{row[0][i], row[1][i], row[2][i]});
        };
        const Points n = point(rows.n), u = point(rows.u), v = point(rows.v);
        const Floats margin = splat(rows.margin[i]), grazing = splat(rows.grazing[i] * beam_.dir_reach);
        const Floats offset = splat(rows.offset[i]);
        const uint32_t id = leaf.id(i);
        for (; blocks != 0; blocks &= blocks - 1) {
            const uint32_t block = lowest_bit(blocks), bits = selection_.blocks[block];
            for (uint32_t part = 0; part < block_size; part += lane_count) {
                const uint32_t lanes = (bits >> part) & all_lanes;
                if (lanes == 0) continue;
                const uint32_t ray = block * block_size + part;
                const Points dir = rays_.dir(ray);
                const Floats det = dot(n, dir);
                const FilterResult result = judge(det, fused_dot(u, dir), fused_dot(v, dir), margin);
                uint32_t possible = bits_of(result.possible) & lanes;
                if (possible == 0) continue;
                possible &= ~this->lanes_that_left(id, ray);
                if (possible == 0) continue;
                Floats t = offset / det;
                const uint32_t settled = bits_of(hn::And(result.certain, hn::Ge(hn::Abs(det), grazing)));
                if ((possible & ~settled) != 0) t = with_distances(leaf, i, ray, possible & ~settled, t);
                this->take_nearer(id, ray, possible, t);
            }
        }
    }

    /// Asks the definition for some of the lanes.
    HWY_NOINLINE Floats with_distances(const LeafFromPoint &leaf, uint32_t i, uint32_t ray, uint32_t lanes,
                                       Floats t) const {
        alignas(64) float distances[lane_count];
        hn::Store(t, floats, distances);
        for (; lanes != 0; lanes &= lanes - 1) {
            const uint32_t lane = lowest_bit(lanes), r = ray + lane;
            distances[lane] = leaf.exact(i, rays_.shared_origin, {rays_.dir_x[r], rays_.dir_y[r], rays_.dir_z[r]});
        }
        return hn::Load(floats, distances);
    }

    StreamTrace<true, any_hit> streams_;
    bool streams_ready_ = false;
    float block_area_ = 0.0f;         ///< a block's mean area across the beam, at depth 1
    Pending stack_[most_pending + 1]; ///< one that turns out not to wait is written too
};

} // namespace glint::HWY_NAMESPACE
