// The finished wide bounding volume hierarchy: arrays that traversal reads.
#pragma once

#include <cstdint>
#include <span>

#include "accel/leaf_triangles.hpp"
#include "accel/triangle_data.hpp"
#include "accel/uninitialized_vector.hpp"
#include "math/box.hpp"
#include "threads/crew.hpp"

namespace glint {

/// Up to eight children, their boxes coordinate by coordinate: one vector instruction deals with all of them (Wald,
/// Benthin & Boulos 2008, "Getting rid of packets"). Places without a child hold an empty box: lowest above highest.
/// Its size makes it four cache lines and not five, which may be asked for ahead.
struct alignas(64) WideNode {
    static constexpr uint32_t width = 8;

    float bounds[6][width]; ///< lowest x, y, z; highest x, y, z
    uint32_t child[width];  ///< ChildLink

    static constexpr uint32_t lowest = 0, highest = 3;
};
static_assert(sizeof(WideNode) == 256);

/// Where a child is found: a node of this number or, with a count, a leaf whose first reference has this number.
class ChildLink {
public:
    static constexpr uint32_t count_bits = 4;
    static constexpr uint32_t max_count = (1u << count_bits) - 1;
    static constexpr uint32_t max_number = UINT32_MAX >> count_bits;

    explicit ChildLink(uint32_t word) : word_(word) {}
    [[nodiscard]] static ChildLink node(uint32_t number) { return ChildLink(number << count_bits); }
    [[nodiscard]] static ChildLink leaf(uint32_t first_reference, uint32_t count) {
        return ChildLink(first_reference << count_bits | count);
    }

    [[nodiscard]] bool is_leaf() const { return reference_count() != 0; }
    [[nodiscard]] uint32_t reference_count() const { return word_ & max_count; }
    [[nodiscard]] uint32_t number() const { return word_ >> count_bits; }
    [[nodiscard]] uint32_t word() const { return word_; }

private:
    uint32_t word_;
};

struct WideBvh {
    Box bounds;                               ///< of all triangles
    UninitializedVector<WideNode> nodes;      ///< depth-first; node 0 is the root
    UninitializedVector<uint32_t> leaf_words; ///< triangles, leaf after leaf: see leaf_triangles.hpp

    [[nodiscard]] size_t reference_count() const { return (leaf_words.size() - leaf_padding) / words_per_reference; }
};

/// More triangles than this do not fit.
inline constexpr uint32_t max_bvh_triangles = ChildLink::max_number;
/// Nodes lie at most this deep, so that a traversal's stack has a fixed size.
inline constexpr uint32_t max_bvh_depth = 64;

/// Builds the hierarchy over triangles that all have an area; a binary one first (binary_bvh.hpp), which
/// is made better (reinsertion.hpp) and drawn together (collapse.hpp). The result does not depend on the number of
/// threads.
[[nodiscard]] WideBvh build_wide_bvh(std::span<const TriangleCorners> triangles, const Crew &crew);

} // namespace glint
