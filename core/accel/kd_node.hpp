// What a node of the kd-tree looks like in memory.
#pragma once

#include <cstdint>

#include "math/bits.hpp"

namespace glint {

/// A kd-tree node in eight bytes. Nodes stand in depth-first order: an inner node's lower child is the next node.
///
///     word 0   31 ......................... 2   1 0
///     inner    index of the upper child        axis (0 x, 1 y, 2 z)
///     leaf     number of references            3
///
///     word 1   31 ............................... 0
///     inner    split position along the axis, float
///     leaf     index of the first reference
///
/// The lower child's cell is everything with coordinate <= split, the upper one's everything >= split.
class KdNode {
public:
    static constexpr uint32_t leaf_tag = 3;
    static constexpr uint32_t max_index = (1u << 30) - 1;

    KdNode() = default; ///< nothing yet

    [[nodiscard]] static KdNode inner(uint32_t axis, float split, uint32_t upper_child) {
        return KdNode((upper_child << 2) | axis, bit_cast<uint32_t>(split));
    }
    [[nodiscard]] static KdNode leaf(uint32_t first_reference, uint32_t reference_count) {
        return KdNode((reference_count << 2) | leaf_tag, first_reference);
    }

    [[nodiscard]] bool is_leaf() const { return (word0_ & 3) == leaf_tag; }
    [[nodiscard]] uint32_t axis() const { return word0_ & 3; }
    [[nodiscard]] uint32_t upper_child() const { return word0_ >> 2; }
    [[nodiscard]] float split() const { return bit_cast<float>(word1_); }
    [[nodiscard]] uint32_t reference_count() const { return word0_ >> 2; }
    [[nodiscard]] uint32_t first_reference() const { return word1_; }

private:
    KdNode(uint32_t word0, uint32_t word1) : word0_(word0), word1_(word1) {}

    uint32_t word0_;
    uint32_t word1_;
};
static_assert(sizeof(KdNode) == 8);

} // namespace glint
