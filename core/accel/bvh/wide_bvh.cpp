// Draws the binary hierarchy together into the wide one.
#include "accel/bvh/wide_bvh.hpp"

#include <algorithm>
#include <limits>

#include "accel/bvh/binary_bvh.hpp"
#include "threads/parallel_for.hpp"

namespace glint {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

class Collapse {
public:
    Collapse(const BinaryBvh &binary, WideBvh &wide) : binary_(binary), wide_(wide) {}

    /// Makes the wide node that stands for a binary one; returns its number.
    uint32_t make_node(uint32_t root) {
        uint32_t children[WideNode::width];
        const uint32_t count = choose_children(root, children);
        const auto number = static_cast<uint32_t>(wide_.nodes.size());
        wide_.nodes.emplace_back();
        set_boxes(wide_.nodes.back(), children, count);
        for (uint32_t i = 0; i < count; ++i) {
            const BinaryNode &child = binary_.nodes[children[i]];
            const uint32_t link = child.is_leaf() ? ChildLink::leaf(child.first, child.count).word()
                                                  : ChildLink::node(make_node(children[i])).word();
            wide_.nodes[number].child[i] = link;
        }
        return number;
    }

private:
    /// Opens the largest node again and again, until there are eight or all are leaves.
    uint32_t choose_children(uint32_t root, uint32_t (&children)[WideNode::width]) const {
        children[0] = root;
        uint32_t count = 1;
        while (count < WideNode::width) {
            uint32_t largest = count;
            float area = -1.0f;
            for (uint32_t i = 0; i < count; ++i) {
                const BinaryNode &node = binary_.nodes[children[i]];
                if (!node.is_leaf() && node.half_area() > area) area = node.half_area(), largest = i;
            }
            if (largest == count) break;
            const uint32_t first = binary_.nodes[children[largest]].first;
            children[largest] = first;
            children[count++] = first + 1;
        }
        return count;
    }

    void set_boxes(WideNode &node, const uint32_t *children, uint32_t count) const {
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
    const BinaryBvh binary = build_binary_bvh(triangles, crew);
    const BinaryNode &root = binary.nodes[0];
    wide.bounds.lo = {root.lo[0], root.lo[1], root.lo[2]};
    wide.bounds.hi = {root.hi[0], root.hi[1], root.hi[2]};
    wide.nodes.reserve(triangles.size() / 16 + 16);
    Collapse(binary, wide).make_node(0);
    wide.nodes.shrink_to_fit();
    write_leaves(binary, triangles, crew, wide);
    return wide;
}

} // namespace glint
