// The children of a wide node as lanes.
#pragma once

#include "accel/bvh/wide_bvh.hpp"
#include "kernel/packet/beam.hpp"
#include "kernel/packet/lanes.hpp"
#include "kernel/traverse.hpp"

namespace glint::HWY_NAMESPACE {

/// Asks for what a link leads to, before it is visited.
HWY_INLINE void prefetch(const GeometryView &geometry, ChildLink link) {
    // Without a branch, which nothing foretells.
    const char *const bases[2] = {reinterpret_cast<const char *>(geometry.wide_nodes),
                                  reinterpret_cast<const char *>(geometry.leaf_words)};
    static constexpr size_t strides[2] = {sizeof(WideNode), words_per_reference * sizeof(uint32_t)};
    const uint32_t is_leaf = link.is_leaf() ? 1 : 0;
    const char *const at = bases[is_leaf] + strides[is_leaf] * link.number();
    constexpr int lines = 6; // as many as a leaf of eight triangles has
    for (int line = 0; line < lines; ++line) __builtin_prefetch(at + 64 * line);
}

/// Puts the children whose bits are set in order, far ones first, so that near ones are on top of a stack; returns how
/// many. `begins` are not negative.
HWY_INLINE uint32_t far_first(const float *begins, uint32_t children, uint32_t *order) {
    // Each finds its own place: how many are farther. Nothing foretells how comparisons of distances end, and so none
    // decides a branch. The lowest bits, which hardly matter, make all of them different.
    constexpr hn::RebindToSigned<NarrowTag> narrow_ints;
    alignas(32) int32_t keys[WideNode::width];
    for (uint32_t c = 0; c < WideNode::width; c += narrow_lanes) {
        const auto begin = hn::BitCast(narrow_ints, hn::Load(narrow_floats, begins + c));
        const auto number = hn::Iota(narrow_ints, static_cast<int32_t>(c));
        hn::Store(hn::Or(hn::AndNot(hn::Set(narrow_ints, WideNode::width - 1), begin), number), narrow_ints, keys + c);
    }
    for (uint32_t rest = children; rest != 0; rest &= rest - 1) {
        const uint32_t child = lowest_bit(rest);
        uint32_t farther = 0;
        for (uint32_t c = 0; c < WideNode::width; c += narrow_lanes) {
            const auto others = hn::Load(narrow_ints, keys + c), own = hn::Set(narrow_ints, keys[child]);
            farther |= bits_of(narrow_ints, hn::Gt(others, own)) << c;
        }
        order[__builtin_popcount(farther & children)] = child;
    }
    return static_cast<uint32_t>(__builtin_popcount(children));
}

/// Children that wait for their turn, the nearest on top.
class WaitingChildren {
public:
    /// Of the children whose bits are set (one at least), which begin there, the nearest is returned; the others wait.
    template <bool in_order> HWY_INLINE ChildLink nearest_of(const GeometryView &geometry, const WideNode &node,
                                                             const float *begins, uint32_t entered) {
        const uint32_t first = lowest_bit(entered);
        prefetch(geometry, ChildLink(node.child[first]));
        if ((entered &= entered - 1) == 0) return ChildLink(node.child[first]);
        uint64_t nearest = entry(node, begins, first);
        uint64_t *const bottom = top_;
        for (; entered != 0; entered &= entered - 1) {
            const uint32_t i = lowest_bit(entered);
            prefetch(geometry, ChildLink(node.child[i]));
            const uint64_t other = entry(node, begins, i), farther = larger(nearest, other);
            nearest = smaller(nearest, other);
            uint64_t *place = top_++;
            if constexpr (in_order) {
                for (; place != bottom && place[-1] < farther; --place) *place = place[-1];
            }
            *place = farther;
        }
        return ChildLink(static_cast<uint32_t>(nearest));
    }

    /// The next that begins before `end`; false if there is none.
    HWY_INLINE bool next(float end, ChildLink &child) {
        do {
            if (top_ == entries_) return false;
            --top_;
        } while (__builtin_bit_cast(float, static_cast<uint32_t>(*top_ >> 32)) > end);
        child = ChildLink(static_cast<uint32_t>(*top_));
        return true;
    }

private:
    /// Where it begins in the upper half: not negative, and so in order as a number too.
    static HWY_INLINE uint64_t entry(const WideNode &node, const float *begins, uint32_t i) {
        return uint64_t{__builtin_bit_cast(uint32_t, begins[i])} << 32 | node.child[i];
    }

    uint64_t entries_[(WideNode::width - 1) * max_bvh_depth + WideNode::width];
    uint64_t *top_ = entries_;
};

/// Bit i for every child that the beam may enter, and how far behind the beam's own begin it does.
HWY_INLINE uint32_t children_in_beam(const Beam &beam, const WideNode &node, float *begins) {
    const BeamAxes &axes = beam.axes;
    const uint32_t z_near = static_cast<uint32_t>(axes.z) + (axes.sign > 0.0f ? WideNode::lowest : WideNode::highest);
    const uint32_t z_far = static_cast<uint32_t>(2 * axes.z) + WideNode::highest - z_near;
    uint32_t entered = 0;
    for (uint32_t i = 0; i < WideNode::width; i += narrow_lanes) {
        const auto row = [&](uint32_t r) { return hn::Load(narrow_floats, node.bounds[r] + i); };
        const auto sign = narrow_splat(axes.sign), base_z = narrow_splat(axes.base_z());
        const auto z_lo = (row(z_near) - base_z) * sign, z_hi = (row(z_far) - base_z) * sign;
        const auto from = hn::Max(z_lo, narrow_splat(beam.z_begin)), to = hn::Min(z_hi, narrow_splat(beam.z_end));
        auto inside = hn::Le(from, to + narrow_splat(2.0f * beam.slack));
        for (int side = 0; side < 4; ++side) {
            const int axis = side < 2 ? axes.u : axes.v;
            const auto base = narrow_splat(side < 2 ? axes.base_u() : axes.base_v());
            const auto slope = narrow_splat(beam.slope[side]);
            const auto reach = narrow_splat(beam.offset[side]) + hn::Max(slope * from, slope * to);
            const auto across = side % 2 == 0 ? base - row(static_cast<uint32_t>(axis) + WideNode::highest)
                                              : row(static_cast<uint32_t>(axis) + WideNode::lowest) - base;
            inside = hn::And(inside, hn::Le(across, reach));
        }
        hn::Store(from - narrow_splat(beam.z_begin), narrow_floats, begins + i);
        entered |= bits_of(narrow_floats, inside) << i;
    }
    return entered;
}

} // namespace glint::HWY_NAMESPACE
