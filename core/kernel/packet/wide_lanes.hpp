// The children of a wide node as lanes.
#pragma once

#include "accel/bvh/wide_bvh.hpp"
#include "kernel/packet/beam.hpp"
#include "kernel/packet/lanes.hpp"

namespace glint::HWY_NAMESPACE {

using NodeTag = hn::CappedTag<float, WideNode::width>;
using NodeFloats = hn::Vec<NodeTag>;
inline constexpr NodeTag node_floats;
/// Children of a node in one vector.
inline constexpr uint32_t node_lanes = lane_count < WideNode::width ? lane_count : WideNode::width;

inline constexpr uint32_t bvh_stack_size = (WideNode::width - 1) * max_bvh_depth + WideNode::width;

HWY_INLINE uint32_t node_bits(hn::Mask<NodeTag> mask) {
#if HWY_TARGET == HWY_AVX3
    return mask.raw;
#else
    uint64_t bits = 0;
    hn::StoreMaskBits(node_floats, mask, reinterpret_cast<uint8_t *>(&bits));
    return static_cast<uint32_t>(bits) & ((1u << node_lanes) - 1);
#endif
}

/// A child that waits: where it begins in the upper half, positive and so in order as a number too.
HWY_INLINE uint64_t pending_child(const WideNode &node, const float *begins, uint32_t i) {
    return uint64_t{__builtin_bit_cast(uint32_t, begins[i])} << 32 | node.child[i];
}
HWY_INLINE float begin_of(uint64_t child) {
    return __builtin_bit_cast(float, static_cast<uint32_t>(child >> 32));
}

/// Bit i for every child that the beam may enter.
HWY_INLINE uint32_t children_in_beam(const Beam &beam, const WideNode &node, float *begins) {
    const BeamAxes &axes = beam.axes;
    const uint32_t z_near = static_cast<uint32_t>(axes.z) + (axes.sign > 0.0f ? WideNode::lowest : WideNode::highest);
    const uint32_t z_far = static_cast<uint32_t>(2 * axes.z) + WideNode::highest - z_near;
    uint32_t entered = 0;
    const auto set = [](float value) { return hn::Set(node_floats, value); };
    for (uint32_t i = 0; i < WideNode::width; i += node_lanes) {
        const auto row = [&](uint32_t r) { return hn::Load(node_floats, node.bounds[r] + i); };
        const auto sign = set(axes.sign), base_z = set(axes.base_z());
        const auto z_lo = (row(z_near) - base_z) * sign, z_hi = (row(z_far) - base_z) * sign;
        const auto from = hn::Max(z_lo, set(beam.z_begin)), to = hn::Min(z_hi, set(beam.z_end));
        auto inside = hn::Le(from, to + set(2.0f * beam.slack));
        for (int side = 0; side < 4; ++side) {
            const int axis = side < 2 ? axes.u : axes.v;
            const auto base = set(side < 2 ? axes.base_u() : axes.base_v());
            const auto slope = set(beam.slope[side]);
            const auto reach = set(beam.offset[side]) + hn::Max(slope * from, slope * to);
            const auto across = side % 2 == 0 ? base - row(static_cast<uint32_t>(axis) + WideNode::highest)
                                              : row(static_cast<uint32_t>(axis) + WideNode::lowest) - base;
            inside = hn::And(inside, hn::Le(across, reach));
        }
        hn::Store(hn::Max(from, hn::Zero(node_floats)), node_floats, begins + i);
        entered |= node_bits(inside) << i;
    }
    return entered;
}

} // namespace glint::HWY_NAMESPACE
