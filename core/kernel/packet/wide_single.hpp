// A ray that goes its own way through the wide hierarchy: the eight children of a node at once (Wald, Benthin & Boulos
// 2008, "Getting rid of packets").
#pragma once

#include "kernel/packet/single_trace.hpp"
#include "kernel/packet/wide_lanes.hpp"

namespace glint::HWY_NAMESPACE {

/// A ray as its way through boxes needs it: t = bound * inverse - offset, where the offsets include the slack. Rows
/// count from a node's first bound.
struct WideSlabs {
    NodeFloats inverse_x, inverse_y, inverse_z;
    NodeFloats near_offset_x, near_offset_y, near_offset_z, far_offset_x, far_offset_y, far_offset_z;
    size_t near_x, near_y, near_z, far_x, far_y, far_z;

    HWY_INLINE WideSlabs(const Point3 &inverse, const Point3 &near_offset, const Point3 &far_offset)
        : inverse_x(hn::Set(node_floats, inverse.x)),
          inverse_y(hn::Set(node_floats, inverse.y)),
          inverse_z(hn::Set(node_floats, inverse.z)),
          near_offset_x(hn::Set(node_floats, near_offset.x)),
          near_offset_y(hn::Set(node_floats, near_offset.y)),
          near_offset_z(hn::Set(node_floats, near_offset.z)),
          far_offset_x(hn::Set(node_floats, far_offset.x)),
          far_offset_y(hn::Set(node_floats, far_offset.y)),
          far_offset_z(hn::Set(node_floats, far_offset.z)),
          near_x(row(inverse.x > 0.0f, 0)),
          near_y(row(inverse.y > 0.0f, 1)),
          near_z(row(inverse.z > 0.0f, 2)),
          far_x(row(inverse.x <= 0.0f, 0)),
          far_y(row(inverse.y <= 0.0f, 1)),
          far_z(row(inverse.z <= 0.0f, 2)) {}

    static HWY_INLINE size_t row(bool lower, size_t axis) {
        return WideNode::width * (axis + (lower ? WideNode::lowest : WideNode::highest));
    }

    /// Bit i for every child that the ray may enter before `end`, and where it does.
    HWY_INLINE uint32_t enter(const WideNode &node, float end, float *begins) const {
        uint32_t entered = 0;
        for (uint32_t i = 0; i < WideNode::width; i += node_lanes) {
            const auto bound = [&](size_t first) { return hn::Load(node_floats, node.bounds[0] + first + i); };
            const auto begin =
                hn::Max(hn::Max(hn::MulSub(bound(near_x), inverse_x, near_offset_x),
                                hn::MulSub(bound(near_y), inverse_y, near_offset_y)),
                        hn::Max(hn::MulSub(bound(near_z), inverse_z, near_offset_z), hn::Zero(node_floats)));
            const auto stop =
                hn::Min(hn::Min(hn::MulSub(bound(far_x), inverse_x, far_offset_x),
                                hn::MulSub(bound(far_y), inverse_y, far_offset_y)),
                        hn::Min(hn::MulSub(bound(far_z), inverse_z, far_offset_z), hn::Set(node_floats, end)));
            hn::Store(begin, node_floats, begins + i);
            entered |= node_bits(hn::Le(begin, stop)) << i;
        }
        return entered;
    }
};

/// One ray through all that a link leads to; `unit` is that of the slabs' distances, other arguments and result as
/// hit_leaf() has them.
template <bool any_hit> HWY_INLINE bool walk_wide(const TraceQuestion &question, const WideSlabs &slabs, ChildLink next,
                                                  float unit, const Point3 &org, const Point3 &dir, float dir_reach,
                                                  float reach, uint32_t left, float &best_t, uint32_t &best_id) {
    const WideNode *const nodes = question.geometry.wide_nodes;
    uint64_t stack[bvh_stack_size];
    uint64_t *top = stack;
    float end = (best_t + distance_error * best_t) * unit;
    bool hit = false;
    while (true) {
        if (!next.is_leaf()) {
            const WideNode &node = nodes[next.number()];
            alignas(32) float begins[WideNode::width];
            uint32_t entered = slabs.enter(node, end, begins);
            if (entered != 0) {
                const uint32_t first = lowest_bit(entered);
                entered &= entered - 1;
                if (entered == 0) {
                    next = ChildLink(node.child[first]);
                    continue;
                }
                uint64_t nearest = pending_child(node, begins, first);
                uint64_t *const bottom = top;
                do {
                    const uint64_t other = pending_child(node, begins, lowest_bit(entered));
                    entered &= entered - 1;
                    const uint64_t farther = larger(nearest, other);
                    nearest = smaller(nearest, other);
                    uint64_t *place = top++;
                    if constexpr (!any_hit) {
                        for (; place != bottom && place[-1] < farther; --place) *place = place[-1];
                    }
                    *place = farther;
                } while (entered != 0);
                next = ChildLink(static_cast<uint32_t>(nearest));
                continue;
            }
        } else if (hit_leaf<any_hit>(question, next.number(), next.reference_count(), org, dir, dir_reach, reach, left,
                                     best_t, best_id)) {
            if (any_hit) return true;
            hit = true;
            end = (best_t + distance_error * best_t) * unit;
        }
        do {
            if (top == stack) return hit;
            --top;
        } while (begin_of(*top) > end);
        next = ChildLink(static_cast<uint32_t>(*top));
    }
}

} // namespace glint::HWY_NAMESPACE
