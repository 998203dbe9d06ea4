// Builds the kd-tree: its top with all threads at once, then a subtree for each thread, then lays all of it in a row.
#include "accel/kd_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "accel/subtree.hpp"
#include "accel/top_of_tree.hpp"
#include "accel/tree_layout.hpp"
#include "threads/parallel_for.hpp"

namespace glint {

namespace {

/// Wald & Havran 2006 bound the depth by 8 + 1.3 log2(n); beyond that a leaf is full of overlapping triangles that no
/// plane separates.
uint32_t depth_limit(size_t triangle_count) {
    const double log2_count = std::log2(static_cast<double>(triangle_count + 1));
    return std::min(max_tree_depth, static_cast<uint32_t>(8.0 + 1.3 * log2_count));
}

/// A mesh needs about two references a triangle; many more come about where triangles cross each other and splitting
/// does not help. Small trees may be wasteful.
double reference_budget(size_t triangle_count) {
    return 2.5 * static_cast<double>(triangle_count) + 10'000.0;
}

/// The whole scene, every triangle in it.
FilledCell root_of(std::span<const TriangleCorners> triangles, const Crew &crew) {
    constexpr size_t piece_size = 16384;
    FilledCell root;
    root.cell.levels_left = depth_limit(triangles.size());
    root.cell.reference_budget = reference_budget(triangles.size());
    root.references.resize(triangles.size());
    std::vector<Box> boxes((triangles.size() + piece_size - 1) / piece_size);
    parallel_for_pieces(triangles.size(), piece_size, crew, [&](size_t begin, size_t end) {
        Box &box = boxes[begin / piece_size];
        for (size_t id = begin; id < end; ++id) {
            root.references[id] = {triangles[id].bounds(), static_cast<uint32_t>(id)};
            box.extend(root.references[id].bounds);
        }
    });
    for (const Box &box : boxes) root.cell.box.extend(box);
    root.occupied = root.cell.box;
    return root;
}

/// The subtrees of all cells, in the cells' order; leaves no references behind.
std::vector<Subtree> grow_subtrees(std::vector<FilledCell> &cells, std::span<const TriangleCorners> triangles,
                                   const Crew &crew) {
    std::vector<size_t> large_first(cells.size());
    std::iota(large_first.begin(), large_first.end(), size_t{0});
    std::sort(large_first.begin(), large_first.end(),
              [&](size_t a, size_t b) { return cells[a].references.size() > cells[b].references.size(); });
    std::vector<SubtreeBuilder> builders(crew.threads, SubtreeBuilder(triangles));
    std::vector<Subtree> subtrees(cells.size());
    parallel_for(cells.size(), crew, [&](size_t i, unsigned thread) {
        FilledCell &cell = cells[large_first[i]];
        subtrees[large_first[i]] = builders[thread].build(cell.cell, cell.references);
        cell.references = {};
    });
    return subtrees;
}

} // namespace

KdTree build_kd_tree(std::span<const TriangleCorners> triangles, const Crew &crew) {
    FilledCell root = root_of(triangles, crew);
    const Box bounds = root.cell.box;
    TopOfTree top = build_top(std::move(root), triangles, crew);
    const std::vector<Subtree> subtrees = grow_subtrees(top.cells, triangles, crew);
    KdTree tree = lay_out(top, subtrees, triangles, crew);
    tree.bounds = bounds;
    return tree;
}

KdTree single_leaf_tree(std::span<const TriangleCorners> triangles) {
    KdTree tree;
    for (const TriangleCorners &triangle : triangles) tree.bounds.extend(triangle.bounds());
    const auto count = static_cast<uint32_t>(triangles.size());
    std::vector<uint32_t> ids(count);
    std::iota(ids.begin(), ids.end(), 0u);
    tree.nodes.push_back(KdNode::leaf(0, count));
    tree.leaf_words.resize(count * words_per_reference + leaf_padding);
    write_leaf(tree.leaf_words.data(), ids.data(), count, triangles);
    std::fill(tree.leaf_words.end() - leaf_padding, tree.leaf_words.end(), 0u);
    return tree;
}

} // namespace glint
