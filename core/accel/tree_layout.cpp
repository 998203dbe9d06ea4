// Lays the parts of a tree out in the order that traversal reads: first every part gets its place, then threads fill
// the places.
#include "accel/tree_layout.hpp"

#include "threads/parallel_for.hpp"

namespace glint {

namespace {

/// Where a subtree goes.
struct Place {
    uint32_t first_node, first_reference;
};

class Layout {
public:
    Layout(const TopOfTree &top, const std::vector<Subtree> &subtrees)
        : top_(top), subtrees_(subtrees), places_(subtrees.size()) {
        size_t nodes = top.branches.size() - subtrees.size();
        for (const Subtree &subtree : subtrees) nodes += subtree.nodes.size();
        tree_.nodes.resize(nodes);
        place(0);
        tree_.leaf_words.resize(size_t{references_} * words_per_reference + leaf_padding);
        std::fill(tree_.leaf_words.end() - leaf_padding, tree_.leaf_words.end(), 0u);
    }

    /// Copies a subtree to its place, and its triangles with it.
    void fill(size_t number, std::span<const TriangleCorners> triangles) {
        const Subtree &subtree = subtrees_[number];
        const auto [first_node, first_reference] = places_[number];
        KdNode *to = tree_.nodes.data() + first_node;
        for (const KdNode &node : subtree.nodes) {
            if (node.is_leaf()) {
                const uint32_t first = first_reference + node.first_reference();
                write_leaf(tree_.leaf_words.data() + size_t{first} * words_per_reference,
                           subtree.triangle_ids.data() + node.first_reference(), node.reference_count(), triangles);
                *to++ = KdNode::leaf(first, node.reference_count());
            } else {
                *to++ = KdNode::inner(node.axis(), node.split(), first_node + node.upper_child());
            }
        }
    }

    [[nodiscard]] KdTree take() { return std::move(tree_); }

private:
    /// Gives a branch its place behind all that have one, and writes its inner nodes.
    void place(uint32_t branch_number) {
        const Branch &branch = top_.branches[branch_number];
        if (!branch.split.exists()) {
            const Subtree &subtree = subtrees_[branch.cell];
            places_[branch.cell] = {nodes_, references_};
            nodes_ += static_cast<uint32_t>(subtree.nodes.size());
            references_ += static_cast<uint32_t>(subtree.triangle_ids.size());
            return;
        }
        const uint32_t node = nodes_++;
        place(branch.lower);
        tree_.nodes[node] = KdNode::inner(static_cast<uint32_t>(branch.split.axis), branch.split.position, nodes_);
        place(branch.upper);
    }

    const TopOfTree &top_;
    const std::vector<Subtree> &subtrees_;
    std::vector<Place> places_; // by subtree
    uint32_t nodes_ = 0, references_ = 0;
    KdTree tree_;
};

} // namespace

KdTree lay_out(const TopOfTree &top, const std::vector<Subtree> &subtrees, std::span<const TriangleCorners> triangles,
               const Crew &crew) {
    Layout layout(top, subtrees);
    parallel_for(subtrees.size(), crew, [&](size_t i, unsigned) { layout.fill(i, triangles); });
    return layout.take();
}

} // namespace glint
