// A group of rays that go one way: the tree, either kind, is walked once for all of them.
#pragma once

#include "kernel/packet/group_test.hpp"
#include "kernel/packet/wide_lanes.hpp"
#include "kernel/traverse.hpp"

namespace glint::HWY_NAMESPACE {

template <bool shares_origin, bool any_hit> class GroupTrace : private GroupTest<shares_origin, any_hit> {
    using Test = GroupTest<shares_origin, any_hit>;
    using Test::beam_, Test::question_, Test::steps_, Test::visit_leaf;

public:
    using Test::Test;

    /// False when the beam turned out to be too wide for what is there: `budget` steps did not do. What was found so
    /// far stands, and makes the next attempt with fewer rays cheaper.
    HWY_INLINE bool walk_bvh(uint32_t budget) {
        const WideNode *const nodes = question_.geometry.wide_nodes;
        WaitingChildren waiting;
        ChildLink next = ChildLink::node(0);
        while (true) {
            if (!next.is_leaf()) {
                steps_ += 2;
                if (steps_ > budget) return false;
                const WideNode &node = nodes[next.number()];
                alignas(32) float begins[WideNode::width];
                const uint32_t entered = children_in_beam(beam_, node, begins);
                if (entered != 0) {
                    next = waiting.nearest_of<true>(question_.geometry, node, begins, entered);
                    continue;
                }
            } else if (visit_leaf(next.number(), next.reference_count())) {
                return true;
            }
            if (!waiting.next((beam_.z_end - beam_.z_begin) + 2.0f * beam_.slack, next)) return true;
        }
    }

    /// The same for the kd-tree.
    HWY_INLINE bool walk_kd_tree(uint32_t budget) {
        const GeometryView &geometry = question_.geometry;
        Cell cell = root_cell(geometry.bounds);
        if (!enter(cell)) return true;
        struct Pending {
            uint32_t node;
            Cell cell;
        };
        Pending stack[max_tree_depth];
        int pending = 0;
        uint32_t index = 0;
        const BeamAxes &axes = beam_.axes;
        while (true) {
            const KdNode node = geometry.nodes[index];
            if (++steps_ > budget) return false;
            if (!node.is_leaf()) {
                const auto axis = static_cast<int>(node.axis());
                const uint32_t lower = index + 1, upper = node.upper_child();
                const float split = node.split() - coordinate(axes.base, axis);
                Cell other = cell;
                if (axis == axes.z) {
                    // Lower is nearer, unless z is turned round.
                    const bool turned = axes.sign < 0.0f;
                    const float z = split * axes.sign;
                    cell.z_hi = z;
                    other.z_lo = z;
                    const bool enters_near = z >= beam_.z_begin && enter(cell);
                    const bool enters_far = z <= beam_.z_end && enter(other);
                    const uint32_t near_child = turned ? upper : lower, far_child = turned ? lower : upper;
                    if (enters_near) {
                        if (enters_far) stack[pending++] = {far_child, other};
                        index = near_child;
                        continue;
                    }
                    if (enters_far) {
                        cell = other;
                        index = far_child;
                        continue;
                    }
                } else {
                    const int side = axis == axes.u ? 0 : 2;
                    const bool enters_lower = split >= -cell.side[side], enters_upper = split <= cell.side[side + 1];
                    cell.hi[side / 2] = split;
                    other.lo[side / 2] = split;
                    if (enters_lower && enters_upper) {
                        // The half that the rays are in before they cross the plane comes first: judged by the beam's
                        // middle, or by the shared origin where the beam goes both ways.
                        const float rising = beam_.slope[side + 1] - beam_.slope[side];
                        const bool both_ways = beam_.slope[side] > 0.0f && beam_.slope[side + 1] > 0.0f;
                        const bool lower_first = both_ways ? split > 0.0f : rising > 0.0f;
                        if (lower_first) {
                            stack[pending++] = {upper, other};
                            index = lower;
                        } else {
                            stack[pending++] = {lower, cell};
                            cell = other;
                            index = upper;
                        }
                        continue;
                    }
                    if (enters_lower) {
                        index = lower;
                        continue;
                    }
                    if (enters_upper) {
                        cell = other;
                        index = upper;
                        continue;
                    }
                }
            } else if (visit_leaf(node.first_reference(), node.reference_count())) {
                return true;
            }
            do {
                if (pending == 0) return true;
                --pending;
            } while (stack[pending].cell.z_lo > beam_.z_end);
            index = stack[pending].node;
            cell = stack[pending].cell;
        }
    }

private:
    /// A cell in the beam's coordinates (lo and hi of u and v), and the beam's sides over the cell's depths.
    struct Cell {
        float z_lo, z_hi;
        float lo[2], hi[2];
        float side[4];
    };

    HWY_INLINE Cell root_cell(const Box &box) const {
        const BeamAxes &axes = beam_.axes;
        const Point3 lo = {box.lo.x, box.lo.y, box.lo.z}, hi = {box.hi.x, box.hi.y, box.hi.z};
        Cell cell;
        cell.lo[0] = coordinate(lo, axes.u) - axes.base_u();
        cell.hi[0] = coordinate(hi, axes.u) - axes.base_u();
        cell.lo[1] = coordinate(lo, axes.v) - axes.base_v();
        cell.hi[1] = coordinate(hi, axes.v) - axes.base_v();
        const float a = (coordinate(lo, axes.z) - axes.base_z()) * axes.sign,
                    b = (coordinate(hi, axes.z) - axes.base_z()) * axes.sign;
        cell.z_lo = smaller(a, b);
        cell.z_hi = larger(a, b);
        return cell;
    }

    /// Works out the beam's sides over the cell's depths; false where the beam passes by the cell.
    HWY_INLINE bool enter(Cell &cell) const {
        const float from = larger(cell.z_lo, beam_.z_begin), to = smaller(cell.z_hi, beam_.z_end);
        for (int i = 0; i < 4; ++i) {
            cell.side[i] = beam_.offset[i] + larger(beam_.slope[i] * from, beam_.slope[i] * to);
        }
        return from <= to + 2.0f * beam_.slack && cell.lo[0] <= cell.side[1] && cell.hi[0] >= -cell.side[0] &&
               cell.lo[1] <= cell.side[3] && cell.hi[1] >= -cell.side[2];
    }
};

} // namespace glint::HWY_NAMESPACE
