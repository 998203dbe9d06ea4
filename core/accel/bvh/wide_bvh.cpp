// Writes the wide hierarchy out of the binary one.
#include "accel/bvh/wide_bvh.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "accel/bvh/binary_bvh.hpp"
#include "accel/bvh/collapse.hpp"
#include "accel/bvh/reinsertion.hpp"
#include "threads/parallel_for.hpp"

namespace glint {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

class NodeWriter {
public:
    NodeWriter(const BinaryBvh &binary, WideBvh &wide) : binary_(binary), collapse_(binary), wide_(wide) {}

    /// Writes the wide node that stands for a binary one, and all below; returns its number.
    uint32_t write_node(uint32_t root) {
        std::array<uint32_t, WideNode::width> children;
        const uint32_t count = collapse_.children_of(root, children);
        const auto number = static_cast<uint32_t>(wide_.nodes.size());
        wide_.nodes.emplace_back();
        set_boxes(wide_.nodes.back(), children, count);
        for (uint32_t i = 0; i < count; ++i) {
            const BinaryNode &child = binary_.nodes[children[i]];
            const uint32_t link = child.is_leaf() ? ChildLink::leaf(child.first, child.count).word()
                                                  : ChildLink::node(write_node(children[i])).word();
            wide_.nodes[number].child[i] = link;
        }
        return number;
    }

private:
    void set_boxes(WideNode &node, const std::array<uint32_t, WideNode::width> &children, uint32_t count) const {
        for (uint32_t i = 0; i < WideNode::width; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                const bool exists = i < count;
                node.bounds[WideNode::lowest + axis][i] = exists ? binary_.nodes[children[i]].lo[axis] : infinity;
                node.bounds[WideNode::highest + axis][i] = exists ? binary_.nodes[children[i]].hi[axis] : -infinity;
            }
            node.child[i] = 0;
        }
    }

    const BinaryBvh &binary_;
    const Collapse collapse_;
    WideBvh &wide_;
};

/// Leaves keep the places that their triangles have in the binary hierarchy.
void write_leaves(const BinaryBvh &binary, std::span<const TriangleCorners> triangles, const Crew &crew,
                  WideBvh &wide) {
    wide.leaf_words.resize(binary.triangle_ids.size() * words_per_reference + leaf_padding);
    std::fill(wide.leaf_words.end() - leaf_padding, wide.leaf_words.end(), 0u);
    parallel_for_pieces(wide.nodes.size(), 1 << 10, crew, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            for (const uint32_t word : wide.nodes[i].child) {
                const ChildLink child(word);
                if (!child.is_leaf()) continue;
                write_leaf(wide.leaf_words.data() + size_t{child.number()} * words_per_reference,
                           binary.triangle_ids.data() + child.number(), child.reference_count(), triangles);
            }
        }
    });
}

} // namespace

WideBvh build_wide_bvh(std::span<const TriangleCorners> triangles, const Crew &crew) {
    WideBvh wide;
    BinaryBvh binary = build_binary_bvh(triangles, crew);
    reinsert_large_nodes(binary);
    const BinaryNode &root = binary.nodes[0];
    wide.bounds.lo = {root.lo[0], root.lo[1], root.lo[2]};
    wide.bounds.hi = {root.hi[0], root.hi[1], root.hi[2]};
    wide.nodes.reserve(triangles.size() / 16 + 16);
    NodeWriter(binary, wide).write_node(0);
    wide.nodes.shrink_to_fit();
    write_leaves(binary, triangles, crew, wide);
    return wide;
}

} // namespace glint
