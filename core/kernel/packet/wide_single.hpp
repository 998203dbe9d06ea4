// A ray that goes its own way through the wide hierarchy: the eight children of a node at once (Wald, Benthin & Boulos
// 2008, "Getting rid of packets").
#pragma once

#include "kernel/packet/single_trace.hpp"
#include "kernel/packet/wide_lanes.hpp"

namespace glint::HWY_NAMESPACE {

/// Where a node has the bounds that rays of an octant of directions meet first, and those that they meet last, counted
/// in floats from its first bound. Bit i of the octant: towards lower coordinates along axis i.
struct WideRows {
    size_t near_x, near_y, near_z;

    HWY_INLINE explicit WideRows(uint32_t octant)
        : near_x(row((octant & 1) != 0 ? WideNode::highest : WideNode::lowest)),
          near_y(row(1 + ((octant & 2) != 0 ? WideNode::highest : WideNode::lowest))),
          near_z(row(2 + ((octant & 4) != 0 ? WideNode::highest : WideNode::lowest))) {}

    [[nodiscard]] HWY_INLINE size_t far_x() const { return row(WideNode::lowest + WideNode::highest) - near_x; }
    [[nodiscard]] HWY_INLINE size_t far_y() const { return row(2 + WideNode::lowest + WideNode::highest) - near_y; }
    [[nodiscard]] HWY_INLINE size_t far_z() const { return row(4 + WideNode::lowest + WideNode::highest) - near_z; }

private:
    static HWY_INLINE size_t row(size_t number) { return WideNode::width * number; }
};

/// A ray as its way through boxes needs it: t = bound * inverse - offset, where the offsets include the slack.
struct WideSlabs {
    NarrowFloats inverse_x, inverse_y, inverse_z;
    NarrowFloats near_offset_x, near_offset_y, near_offset_z, far_offset_x, far_offset_y, far_offset_z;

    HWY_INLINE WideSlabs(const Point3 &inverse, const Point3 &near_offset, const Point3 &far_offset)
        : inverse_x(narrow_splat(inverse.x)),
          inverse_y(narrow_splat(inverse.y)),
          inverse_z(narrow_splat(inverse.z)),
          near_offset_x(narrow_splat(near_offset.x)),
          near_offset_y(narrow_splat(near_offset.y)),
          near_offset_z(narrow_splat(near_offset.z)),
          far_offset_x(narrow_splat(far_offset.x)),
          far_offset_y(narrow_splat(far_offset.y)),
          far_offset_z(narrow_splat(far_offset.z)) {}

    /// Bit i for every child that the ray may enter before `end`, and where it does.
    HWY_INLINE uint32_t enter(const WideNode &node, const WideRows &rows, float end, float *begins) const {
        uint32_t entered = 0;
        for (uint32_t i = 0; i < WideNode::width; i += narrow_lanes) {
            const auto bound = [&](size_t first) { return hn::Load(narrow_floats, node.bounds[0] + first + i); };
            const auto begin =
                hn::Max(hn::Max(hn::MulSub(bound(rows.near_x), inverse_x, near_offset_x),
                                hn::MulSub(bound(rows.near_y), inverse_y, near_offset_y)),
                        hn::Max(hn::MulSub(bound(rows.near_z), inverse_z, near_offset_z), hn::Zero(narrow_floats)));
            const auto stop =
                hn::Min(hn::Min(hn::MulSub(bound(rows.far_x()), inverse_x, far_offset_x),
                                hn::MulSub(bound(rows.far_y()), inverse_y, far_offset_y)),
                        hn::Min(hn::MulSub(bound(rows.far_z()), inverse_z, far_offset_z), narrow_splat(end)));
            hn::Store(begin, narrow_floats, begins + i);
            entered |= bits_of(narrow_floats, hn::Le(begin, stop)) << i;
        }
        return entered;
    }
};

/// One ray through all that a link leads to; `unit` is that of the slabs' distances, other arguments and result as
/// hit_leaf() has them.
template <bool any_hit> HWY_INLINE bool walk_wide(const TraceQuestion &question, const WideSlabs &slabs,
                                                  const WideRows &rows, ChildLink next, float unit, const LeafRay &ray,
                                                  float &best_t, uint32_t &best_id) {
    const WideNode *const nodes = question.geometry.wide_nodes;
    WaitingChildren waiting;
    float end = (best_t + distance_error * best_t) * unit;
    bool hit = false;
    while (true) {
        if (!next.is_leaf()) {
            const WideNode &node = nodes[next.number()];
            alignas(32) float begins[WideNode::width];
            const uint32_t entered = slabs.enter(node, rows, end, begins);
            if (entered != 0) {
                next = waiting.nearest_of<!any_hit>(question.geometry, node, begins, entered);
                continue;
            }
        } else if (hit_leaf<any_hit>(question, next.number(), next.reference_count(), ray, best_t, best_id)) {
            if (any_hit) return true;
            hit = true;
            end = (best_t + distance_error * best_t) * unit;
        }
        if (!waiting.next(end, next)) return hit;
    }
}

} // namespace glint::HWY_NAMESPACE
