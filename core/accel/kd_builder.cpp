// Builds the kd-tree: splits cells until a leaf is cheaper, large subtrees in parallel, then lays all nodes in a row.
#include "accel/kd_tree.hpp"

#include <cmath>
#include <memory>
#include <numeric>

#include "accel/cost_model.hpp"
#include "accel/split.hpp"
#include "accel/task_group.hpp"

namespace glint {

namespace {

/// Nodes with more references than this look for a split in bins, the others among all boundaries.
constexpr size_t sweep_threshold = 128;
/// Nodes with more references than this are split as tasks of their own.
constexpr size_t task_threshold = 8192;

/// Nodes and references of a subtree, numbered from its own root.
struct Subtree {
    std::vector<KdNode> nodes;
    std::vector<uint32_t> references;
};

/// The top of the tree while it grows: a split with two branches, or a finished subtree.
struct Branch {
    Split split;
    std::unique_ptr<Branch> lower, upper;
    Subtree subtree;
};

/// A cell to be filled, and what lies in it.
struct Cell {
    Box box;
    uint32_t depth = 0;
    std::vector<Reference> references;
};

class Builder {
public:
    explicit Builder(const std::vector<TriangleCorners> &triangles) : triangles_(triangles), cost_(triangles.size()) {
        // Wald & Havran 2006 bound the depth by 8 + 1.3 log2(n); beyond that a leaf is full of overlapping triangles
        // that no plane separates.
        const double log2_count = std::log2(static_cast<double>(triangles.size() + 1));
        depth_limit_ = std::min(max_tree_depth, static_cast<uint32_t>(8.0 + 1.3 * log2_count));
    }

    KdTree build(unsigned threads) {
        KdTree tree;
        auto root = std::make_shared<Cell>();
        root->references.reserve(triangles_.size());
        for (uint32_t id = 0; id < triangles_.size(); ++id) {
            root->references.push_back({triangles_[id].bounds(), id});
            root->box.extend(root->references.back().bounds);
        }
        tree.bounds = root->box;

        Branch top;
        tasks_.spawn([this, &top, cell = std::move(root)] { grow_branch(top, *cell); });
        tasks_.run(threads);
        std::vector<uint32_t> references;
        lay_out(top, tree, references);
        tree.leaf_words.resize(references.size() * words_per_reference + leaf_padding);
        for (const KdNode &node : tree.nodes) {
            if (node.is_leaf()) {
                const size_t first = node.first_reference();
                write_leaf(tree.leaf_words.data() + first * words_per_reference, references.data() + first,
                           node.reference_count(), triangles_);
            }
        }
        return tree;
    }

private:
    /// The split of this cell, or one of infinite cost where a leaf is better.
    [[nodiscard]] Split choose_split(const Cell &cell) const {
        const size_t count = cell.references.size();
        if (count == 0 || cell.depth >= depth_limit_) return {};
        const Split split = count > sweep_threshold ? find_binned_split(cell.references, cell.box, cost_)
                                                    : find_swept_split(cell.references, cell.box, cost_);
        return split.cost < cost_.leaf(count) ? split : Split{};
    }

    /// Moves the cell's references to the two cells that a split makes of it, cutting those that straddle the plane.
    void divide(Cell &cell, const Split &split, Cell &lower, Cell &upper) const {
        lower.box = split.lower_cell(cell.box);
        upper.box = split.upper_cell(cell.box);
        lower.depth = upper.depth = cell.depth + 1;
        size_t lower_count = 0, upper_count = 0;
        for (const Reference &reference : cell.references) {
            lower_count += split.goes_lower(reference.bounds);
            upper_count += split.goes_upper(reference.bounds);
        }
        lower.references.reserve(lower_count);
        upper.references.reserve(upper_count);
        for (const Reference &reference : cell.references) {
            const bool to_lower = split.goes_lower(reference.bounds);
            const bool to_upper = split.goes_upper(reference.bounds);
            if (to_lower && to_upper) {
                put_part(reference, lower);
                put_part(reference, upper);
            } else {
                (to_lower ? lower : upper).references.push_back(reference);
            }
        }
        cell.references = {}; // give the memory back before going deeper
    }

    void put_part(const Reference &reference, Cell &cell) const {
        const Box part = clip_to_cell(triangles_[reference.triangle_id], cell.box);
        if (!part.empty()) cell.references.push_back({part, reference.triangle_id});
    }

    void grow_branch(Branch &branch, Cell &cell) {
        branch.split = cell.references.size() > task_threshold ? choose_split(cell) : Split{};
        if (!std::isfinite(branch.split.cost)) return grow_subtree(branch.subtree, cell);
        auto lower = std::make_shared<Cell>();
        Cell upper;
        divide(cell, branch.split, *lower, upper);
        branch.lower = std::make_unique<Branch>();
        branch.upper = std::make_unique<Branch>();
        tasks_.spawn([this, &to = *branch.lower, from = std::move(lower)] { grow_branch(to, *from); });
        grow_branch(*branch.upper, upper);
    }

    void grow_subtree(Subtree &subtree, Cell &cell) const {
        const Split split = choose_split(cell);
        if (!std::isfinite(split.cost)) {
            const auto first = static_cast<uint32_t>(subtree.references.size());
            for (const Reference &reference : cell.references) subtree.references.push_back(reference.triangle_id);
            subtree.nodes.push_back(KdNode::leaf(first, static_cast<uint32_t>(cell.references.size())));
            return;
        }
        Cell lower, upper;
        divide(cell, split, lower, upper);
        const size_t node = subtree.nodes.size();
        subtree.nodes.push_back(KdNode::leaf(0, 0)); // holds the place until the upper child's index is known
        grow_subtree(subtree, lower);
        const auto upper_child = static_cast<uint32_t>(subtree.nodes.size());
        grow_subtree(subtree, upper);
        subtree.nodes[node] = KdNode::inner(static_cast<uint32_t>(split.axis), split.position, upper_child);
    }

    /// Appends a branch's nodes, depth first, and frees it.
    static void lay_out(Branch &branch, KdTree &tree, std::vector<uint32_t> &references) {
        if (!branch.lower) {
            const auto node_base = static_cast<uint32_t>(tree.nodes.size());
            const auto reference_base = static_cast<uint32_t>(references.size());
            for (const KdNode &node : branch.subtree.nodes) {
                tree.nodes.push_back(node.is_leaf()
                                         ? KdNode::leaf(node.first_reference() + reference_base, node.reference_count())
                                         : KdNode::inner(node.axis(), node.split(), node.upper_child() + node_base));
            }
            references.insert(references.end(), branch.subtree.references.begin(),
                                   branch.subtree.references.end());
            branch.subtree = {};
            return;
        }
        const size_t node = tree.nodes.size();
        tree.nodes.push_back(KdNode::leaf(0, 0));
        lay_out(*branch.lower, tree, references);
        branch.lower.reset();
        const auto upper_child = static_cast<uint32_t>(tree.nodes.size());
        lay_out(*branch.upper, tree, references);
        branch.upper.reset();
        tree.nodes[node] = KdNode::inner(static_cast<uint32_t>(branch.split.axis), branch.split.position, upper_child);
    }

    const std::vector<TriangleCorners> &triangles_;
    CostModel cost_;
    uint32_t depth_limit_;
    TaskGroup tasks_;
};

} // namespace

KdTree build_kd_tree(const std::vector<TriangleCorners> &triangles, unsigned threads) {
    KdTree tree = Builder(triangles).build(threads);
    tree.nodes.shrink_to_fit();
    return tree;
}

KdTree single_leaf_tree(const std::vector<TriangleCorners> &triangles) {
    KdTree tree;
    for (const TriangleCorners &triangle : triangles) tree.bounds.extend(triangle.bounds());
    const auto count = static_cast<uint32_t>(triangles.size());
    std::vector<uint32_t> ids(count);
    std::iota(ids.begin(), ids.end(), 0u);
    tree.nodes.push_back(KdNode::leaf(0, count));
    tree.leaf_words.resize(count * words_per_reference + leaf_padding);
    write_leaf(tree.leaf_words.data(), ids.data(), count, triangles);
    return tree;
}

} // namespace glint
