// Builds what rays find triangles by.
#include "accel/triangle_tree.hpp"

#include <algorithm>

#include "accel/tree_statistics.hpp"

namespace glint {

namespace {

/// Starting a thread takes about as long as building over this many triangles.
constexpr uint32_t triangles_worth_a_thread = 500;

AccelKind kind_that_fits(AccelKind wish, uint32_t triangle_count) {
    // A hierarchy over nothing has no root, and over more triangles than its links count does not fit.
    const bool fits = triangle_count > 0 && triangle_count <= max_bvh_triangles;
    return wish == AccelKind::bvh && !fits ? AccelKind::kdtree : wish;
}

/// Gives the triangles of a leaf other ids.
void renumber_leaf(UninitializedVector<uint32_t> &words, uint32_t first, uint32_t count,
                   std::span<const uint32_t> ids) {
    uint32_t *const leaf = words.data() + words_per_reference * size_t{first} + 9 * size_t{count};
    for (uint32_t i = 0; i < count; ++i) leaf[i] = ids[leaf[i]];
}

} // namespace

TriangleTree TriangleTree::build(std::span<const TriangleCorners> triangles, AccelKind wish, const Crew &all) {
    TriangleTree tree;
    tree.triangle_count = static_cast<uint32_t>(triangles.size());
    tree.kind = kind_that_fits(wish, tree.triangle_count);
    Crew crew = all;
    crew.threads = std::min(all.threads, 1 + tree.triangle_count / triangles_worth_a_thread);
    if (tree.kind == AccelKind::brute) {
        tree.kd = single_leaf_tree(triangles);
    } else if (tree.is_bvh()) {
        tree.bvh = build_wide_bvh(triangles, crew);
    } else {
        tree.kd = build_kd_tree(triangles, crew);
    }
    return tree;
}

void TriangleTree::renumber(std::span<const uint32_t> ids) {
    for (const KdNode &node : kd.nodes) {
        if (node.is_leaf()) renumber_leaf(kd.leaf_words, node.first_reference(), node.reference_count(), ids);
    }
    for (const WideNode &node : bvh.nodes) {
        for (const uint32_t word : node.child) {
            const ChildLink child(word);
            if (child.is_leaf()) renumber_leaf(bvh.leaf_words, child.number(), child.reference_count(), ids);
        }
    }
}

AccelStatistics TriangleTree::measure() const {
    AccelStatistics statistics = is_bvh() ? measure_bvh(bvh, triangle_count) : measure_tree(kd, triangle_count);
    statistics.bytes = kd.nodes.size() * sizeof(KdNode) + kd.leaf_words.size() * sizeof(uint32_t) +
                       bvh.nodes.size() * sizeof(WideNode) + bvh.leaf_words.size() * sizeof(uint32_t);
    return statistics;
}

} // namespace glint
