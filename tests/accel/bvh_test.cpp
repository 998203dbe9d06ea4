// What the builder of the bounding volume hierarchy makes: the same for any number of threads, complete, within its
// limits.
#include "accel/bvh/wide_bvh.hpp"

#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "accel/bvh/binary_bvh.hpp"
#include "accel/tree_statistics.hpp"
#include "support/meshes.hpp"

namespace glint::test {
namespace {

UninitializedVector<TriangleCorners> corners_of(const Mesh &mesh) {
    return TriangleData::from(*scene_of(mesh)).corners;
}

Box child_box(const WideNode &node, uint32_t i) {
    const auto &b = node.bounds;
    return {{b[0][i], b[1][i], b[2][i]}, {b[3][i], b[4][i], b[5][i]}};
}

bool contains(const Box &outer, const Box &inner) {
    for (int axis = 0; axis < 3; ++axis) {
        if (inner.lo[axis] < outer.lo[axis] || inner.hi[axis] > outer.hi[axis]) return false;
    }
    return true;
}

/// Calls visit(link, box, depth) for every child of every node.
void walk(const WideBvh &bvh, const std::function<void(ChildLink, const Box &, uint32_t)> &visit) {
    const std::function<void(uint32_t, uint32_t)> step = [&](uint32_t number, uint32_t depth) {
        const WideNode &node = bvh.nodes.at(number);
        for (uint32_t i = 0; i < WideNode::width; ++i) {
            const ChildLink link(node.child[i]);
            if (link.word() == 0) {
                EXPECT_TRUE(child_box(node, i).empty()) << "a ray could enter a child that is not there";
                continue;
            }
            visit(link, child_box(node, i), depth + 1);
            if (!link.is_leaf()) step(link.number(), depth + 1);
        }
    };
    step(0, 0);
}

TEST(Bvh, does_not_depend_on_the_number_of_threads) {
    const auto triangles = corners_of(torus(200, 100));
    const WideBvh one = build_wide_bvh(triangles, 1);
    for (const unsigned threads : {2u, 8u}) {
        const WideBvh many = build_wide_bvh(triangles, threads);
        ASSERT_EQ(many.nodes.size(), one.nodes.size());
        for (size_t i = 0; i < one.nodes.size();
             ++i) { // piece by piece: what fills a node's cache lines up says nothing
            const WideNode &a = many.nodes[i], &b = one.nodes[i];
            ASSERT_EQ(std::memcmp(a.bounds, b.bounds, sizeof a.bounds), 0) << "node " << i;
            ASSERT_EQ(std::memcmp(a.child, b.child, sizeof a.child), 0) << "node " << i;
        }
        EXPECT_EQ(many.leaf_words, one.leaf_words);
    }
}

class BvhOfEveryMesh : public testing::TestWithParam<NamedMesh> {};

TEST_P(BvhOfEveryMesh, lists_each_triangle_once_within_its_boxes) {
    const auto triangles = corners_of(GetParam().mesh);
    const WideBvh bvh = build_wide_bvh(triangles, 2);
    std::vector<uint32_t> listed(triangles.size(), 0);
    walk(bvh, [&](ChildLink link, const Box &box, uint32_t depth) {
        EXPECT_LE(depth, max_bvh_depth);
        EXPECT_TRUE(contains(bvh.bounds, box));
        if (!link.is_leaf()) {
            for (uint32_t i = 0; i < WideNode::width; ++i) {
                const WideNode &node = bvh.nodes.at(link.number());
                EXPECT_TRUE(node.child[i] == 0 || contains(box, child_box(node, i)));
            }
            return;
        }
        EXPECT_LE(link.reference_count(), max_bvh_leaf);
        ASSERT_LE(size_t{link.number()} + link.reference_count(), bvh.reference_count());
        const LeafTriangles leaf(bvh.leaf_words.data(), link.number(), link.reference_count());
        for (uint32_t i = 0; i < leaf.count(); ++i) {
            const uint32_t id = leaf.triangle_id(i);
            ASSERT_LT(id, triangles.size());
            ++listed[id];
            const TriangleCorners corners = leaf.corners(i);
            EXPECT_EQ(std::memcmp(&triangles[id], &corners, sizeof corners), 0);
            EXPECT_TRUE(contains(box, leaf.corners(i).bounds()));
        }
    });
    EXPECT_EQ(std::count(listed.begin(), listed.end(), 1u), static_cast<std::ptrdiff_t>(triangles.size()));
}

TEST_P(BvhOfEveryMesh, has_the_statistics_that_a_count_gives) {
    const auto triangles = corners_of(GetParam().mesh);
    const WideBvh bvh = build_wide_bvh(triangles, 1);
    const AccelStatistics statistics = measure_bvh(bvh, static_cast<uint32_t>(triangles.size()));
    uint64_t leaves = 0;
    uint32_t deepest = 0;
    walk(bvh, [&](ChildLink link, const Box &, uint32_t depth) {
        if (!link.is_leaf()) return;
        ++leaves;
        deepest = std::max(deepest, depth);
    });
    EXPECT_EQ(statistics.nodes, bvh.nodes.size() + leaves);
    EXPECT_EQ(statistics.leaves, leaves);
    EXPECT_EQ(statistics.references, triangles.size());
    EXPECT_EQ(statistics.depth, deepest);
    EXPECT_GE(statistics.sah_cost, 1.0);
}

INSTANTIATE_TEST_SUITE_P(meshes, BvhOfEveryMesh, testing::ValuesIn(all_meshes()),
                         [](const auto &test) { return test.param.name; });

TEST(Bvh, stays_shallow_where_no_plane_divides) {
    const TriangleCorners triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<TriangleCorners> copies(100'000, triangle);
    const WideBvh bvh = build_wide_bvh(copies, 2);
    EXPECT_EQ(bvh.reference_count(), copies.size());
    uint32_t deepest = 0;
    walk(bvh, [&](ChildLink, const Box &, uint32_t depth) { deepest = std::max(deepest, depth); });
    EXPECT_LE(deepest, 12u);
}

TEST(Bvh, stays_within_its_depth_where_every_split_cuts_off_one) {
    // Each triangle is a thousand times as far out as the last, so that bins cut off the outermost alone.
    std::vector<TriangleCorners> triangles;
    float at = 1e-18f;
    for (int i = 0; i < 3000; ++i) {
        triangles.push_back({{at, 0, 0}, {at, at, 0}, {at, 0, at}});
        at = at > 1e11f ? 1e-18f : at * 1.03f;
    }
    const WideBvh bvh = build_wide_bvh(triangles, 1);
    uint32_t deepest = 0;
    walk(bvh, [&](ChildLink, const Box &, uint32_t depth) { deepest = std::max(deepest, depth); });
    EXPECT_LE(deepest, max_bvh_depth);
    EXPECT_EQ(bvh.reference_count(), triangles.size());
}

TEST(Bvh, is_what_automatic_makes_of_many_triangles_only) {
    const auto few = scene_of(torus(40, 40)), many = scene_of(torus(60, 60));
    ASSERT_LE(few->triangle_count(), most_triangles_for_kdtree);
    ASSERT_GT(many->triangle_count(), most_triangles_for_kdtree);
    EXPECT_EQ(Accel::build(few)->kind(), AccelKind::kdtree);
    EXPECT_EQ(Accel::build(many)->kind(), AccelKind::bvh);
    EXPECT_EQ(Accel::build(few, {AccelKind::bvh})->kind(), AccelKind::bvh);
    EXPECT_EQ(Accel::build(many, {AccelKind::kdtree})->kind(), AccelKind::kdtree);
}

} // namespace
} // namespace glint::test
