// What the builder makes: the same tree for any number of threads, complete, within its limits.
#include "accel/kd_tree.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <new>

#include <gtest/gtest.h>

#include "accel/cost_model.hpp"
#include "accel/reference.hpp"
#include "accel/tree_statistics.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "threads/parallel_for.hpp"

namespace glint::test {
namespace {

UninitializedVector<TriangleCorners> corners_of(const Mesh &mesh) {
    return TriangleData::from(*scene_of(mesh)).corners;
}

/// Calls visit(node, cell, depth) for every node.
void walk(const KdTree &tree, const std::function<void(const KdNode &, const Box &, uint32_t)> &visit) {
    const std::function<void(uint32_t, Box, uint32_t)> step = [&](uint32_t index, Box cell, uint32_t depth) {
        const KdNode &node = tree.nodes.at(index);
        visit(node, cell, depth);
        if (node.is_leaf()) return;
        const auto axis = static_cast<int>(node.axis());
        ASSERT_GE(node.split(), cell.lo[axis]);
        ASSERT_LE(node.split(), cell.hi[axis]);
        ASSERT_GT(node.upper_child(), index + 1);
        Box lower = cell, upper = cell;
        lower.hi[axis] = upper.lo[axis] = node.split();
        step(index + 1, lower, depth + 1);
        step(node.upper_child(), upper, depth + 1);
    };
    step(0, tree.bounds, 0);
}

TEST(KdTree, does_not_depend_on_the_number_of_threads) {
    // Large enough for subtrees to be tasks of their own.
    const auto triangles = corners_of(torus(200, 100));
    const KdTree one = build_kd_tree(triangles, 1);
    for (const unsigned threads : {2u, 8u}) {
        const KdTree many = build_kd_tree(triangles, threads);
        ASSERT_EQ(many.nodes.size(), one.nodes.size());
        EXPECT_EQ(std::memcmp(many.nodes.data(), one.nodes.data(), one.nodes.size() * sizeof(KdNode)), 0);
        EXPECT_EQ(many.leaf_words, one.leaf_words);
    }
}

class KdTreeOfEveryMesh : public testing::TestWithParam<NamedMesh> {};

TEST_P(KdTreeOfEveryMesh, lists_each_triangle_in_every_leaf_that_it_enters) {
    const auto triangles = corners_of(GetParam().mesh);
    const KdTree tree = build_kd_tree(triangles, 2);
    std::vector<bool> listed(triangles.size(), false);
    walk(tree, [&](const KdNode &node, const Box &cell, uint32_t depth) {
        if (!node.is_leaf()) return;
        ASSERT_LE(depth, max_tree_depth);
        ASSERT_LE(size_t{node.first_reference()} + node.reference_count(), tree.reference_count());
        std::vector<bool> here(triangles.size(), false);
        for (uint32_t i = 0; i < node.reference_count(); ++i) {
            const uint32_t id = tree.leaf(node).triangle_id(i);
            ASSERT_LT(id, triangles.size());
            EXPECT_FALSE(here[id]) << "twice in a leaf";
            here[id] = listed[id] = true;
        }
        // A triangle with its middle strictly inside the cell must be here.
        for (size_t id = 0; id < triangles.size(); ++id) {
            const Point middle = (triangles[id].a + triangles[id].b + triangles[id].c) / 3.0f;
            bool inside = true;
            for (int axis = 0; axis < 3; ++axis) {
                const float margin = 1e-4f * (tree.bounds.hi[axis] - tree.bounds.lo[axis]);
                inside = inside && middle[axis] > cell.lo[axis] + margin && middle[axis] < cell.hi[axis] - margin;
            }
            EXPECT_TRUE(here[id] || !inside) << "triangle " << id << " is missing";
        }
    });
    EXPECT_EQ(std::count(listed.begin(), listed.end(), false), 0);
}

TEST_P(KdTreeOfEveryMesh, has_the_statistics_that_a_count_gives) {
    const auto triangles = corners_of(GetParam().mesh);
    const KdTree tree = build_kd_tree(triangles, 1);
    const AccelStatistics statistics = measure_tree(tree, static_cast<uint32_t>(triangles.size()));
    uint64_t leaves = 0, empty = 0, references = 0;
    uint32_t deepest = 0;
    walk(tree, [&](const KdNode &node, const Box &, uint32_t depth) {
        if (!node.is_leaf()) return;
        ++leaves;
        empty += node.reference_count() == 0;
        references += node.reference_count();
        deepest = std::max(deepest, depth);
    });
    EXPECT_EQ(statistics.nodes, 2 * leaves - 1);
    EXPECT_EQ(statistics.leaves, leaves);
    EXPECT_EQ(statistics.empty_leaves, empty);
    EXPECT_EQ(statistics.references, references);
    EXPECT_EQ(statistics.references, tree.reference_count());
    EXPECT_EQ(statistics.depth, deepest);
    EXPECT_GT(statistics.sah_cost, 0.0);
    const auto count = static_cast<int32_t>(triangles.size());
    EXPECT_LE(statistics.sah_cost, CostModel::leaf(count)) << "worse than no tree";
}

INSTANTIATE_TEST_SUITE_P(meshes, KdTreeOfEveryMesh, testing::ValuesIn(all_meshes()),
                         [](const auto &test) { return test.param.name; });

TEST(KdTree, does_not_fill_memory_where_splits_do_not_help) {
    for (const Mesh &mesh : {soup(30'000), slivers(30'000), stacked_copies(15'000)}) {
        const auto triangles = corners_of(mesh);
        const KdTree tree = build_kd_tree(triangles, 2);
        EXPECT_LT(tree.reference_count(), triangles.size() * 3);
        EXPECT_LT(tree.nodes.size(), triangles.size() * 3);
    }
}

TEST(KdTree, of_a_grid_cuts_no_triangle_twice) {
    // Planes along the grid's lines are there to be found: few triangles are in more than one leaf.
    const auto triangles = corners_of(terrain(200));
    const KdTree tree = build_kd_tree(triangles, 2);
    EXPECT_LT(static_cast<double>(tree.reference_count()), 1.3 * static_cast<double>(triangles.size()));
}

TEST(KdTree, sets_triangles_in_a_face_of_the_scene_apart) {
    // A ground plate of long triangles below a finer terrain: cells above the plate must not list it.
    Mesh mesh = terrain(30);
    const auto base = static_cast<uint32_t>(mesh.positions.size());
    for (int i = 0; i <= 50; ++i) {
        const float x = -1.0f + static_cast<float>(i) / 25.0f;
        mesh.positions.push_back({x, -1.0f, -1.0f});
        mesh.positions.push_back({x, 1.0f, -1.0f});
    }
    for (uint32_t i = 0; i < 50; ++i) {
        mesh.triangles.push_back({base + 2 * i, base + 2 * i + 1, base + 2 * i + 2});
        mesh.triangles.push_back({base + 2 * i + 1, base + 2 * i + 2, base + 2 * i + 3});
    }
    const auto triangles = corners_of(mesh);
    walk(build_kd_tree(triangles, 1), [&](const KdNode &node, const Box &cell, uint32_t) {
        const bool flat = cell.hi.z == cell.lo.z;
        EXPECT_TRUE(!node.is_leaf() || flat || node.reference_count() < 50u) << node.reference_count();
    });
}

TEST(Cut, bounds_what_is_on_either_side) {
    const TriangleCorners triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const auto [lower, upper] = cut(triangle, triangle.bounds(), 0, 1.0f);
    EXPECT_EQ(lower.lo, glm::vec3(0, 0, 0));
    EXPECT_EQ(lower.hi, glm::vec3(1, 4, 0));
    EXPECT_EQ(upper.lo, glm::vec3(1, 0, 0));
    EXPECT_EQ(upper.hi, glm::vec3(4, 3, 0));
}

TEST(Cut, keeps_within_earlier_cuts) {
    const TriangleCorners triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Box corner = cut(triangle, triangle.bounds(), 0, 1.0f).upper; // x 1..4, y 0..3
    const auto [lower, upper] = cut(triangle, corner, 1, 2.0f);
    EXPECT_EQ(lower.lo, glm::vec3(1, 0, 0));
    EXPECT_EQ(lower.hi, glm::vec3(4, 2, 0));
    EXPECT_EQ(upper.lo, glm::vec3(1, 2, 0));
    EXPECT_EQ(upper.hi, glm::vec3(2, 3, 0));
}

TEST(Cut, knows_when_a_part_is_empty) {
    const TriangleCorners triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Box corner{{2.5f, 0, 0}, {4, 4, 0}}; // the triangle is below y = 1.5 here
    EXPECT_FALSE(cut(triangle, corner, 1, 2.0f).lower.empty());
    EXPECT_TRUE(cut(triangle, corner, 1, 2.0f).upper.empty());
    const Box touching{{2, 0, 0}, {4, 4, 0}};
    EXPECT_FALSE(cut(triangle, touching, 1, 2.0f).upper.empty()) << "(2, 2) is on the long edge";
}

TEST(Cut, has_every_crossing_of_an_edge_on_both_sides) {
    Random random(4);
    int crossings = 0;
    for (int i = 0; i < 2000; ++i) {
        const float scale = random.below(2) ? 1e12f : 1e-3f;
        const auto corner = [&] { return random.in_box(glm::vec3(-scale), glm::vec3(scale)); };
        const TriangleCorners triangle = {corner(), corner(), corner()};
        const auto axis = static_cast<int>(random.below(3));
        const float plane = random.uniform(-scale, scale);
        const glm::dvec3 p = triangle.a, q = triangle.b;
        if ((p[axis] < plane) == (q[axis] < plane)) continue;
        ++crossings;
        const glm::dvec3 crossing = p + (q - p) * ((plane - p[axis]) / (q[axis] - p[axis]));
        const double margin = scale * 0x1p-50;
        const auto [lower, upper] = cut(triangle, triangle.bounds(), axis, plane);
        for (const Box &part : {lower, upper}) {
            for (int k = 0; k < 3; ++k) {
                ASSERT_LE(part.lo[k], crossing[k] + margin);
                ASSERT_GE(part.hi[k], crossing[k] - margin);
            }
        }
    }
    EXPECT_GT(crossings, 500);
}

TEST(Cut, never_loses_a_point_of_the_triangle) {
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const float scale = random.below(2) ? 1e12f : 1e-3f, thinness = random.below(2) ? 1.0f : 1e-6f;
        const auto corner = [&] {
            const glm::vec3 p = random.in_box(glm::vec3(-scale), glm::vec3(scale));
            return glm::vec3(p.x, p.y * thinness, p.y + p.z * thinness);
        };
        const TriangleCorners triangle = {corner(), corner(), corner()};
        // Down to a cell as the builder does it, always to the side where this point of the triangle is.
        const double u = random.uniform(0, 0.5f), v = random.uniform(0, 0.5f);
        const glm::dvec3 a = triangle.a, b = triangle.b, c = triangle.c;
        const glm::dvec3 point = a + (b - a) * u + (c - a) * v; // off by less than scale * 2^-50
        const double margin = scale * 0x1p-50;
        Box bounds = triangle.bounds();
        for (int level = 0; level < 20; ++level) {
            const auto axis = static_cast<int>(random.below(3));
            const float plane = random.uniform(bounds.lo[axis], bounds.hi[axis]);
            if (!(bounds.lo[axis] < plane && plane < bounds.hi[axis])) continue;
            const auto [lower, upper] = cut(triangle, bounds, axis, plane);
            bounds = point[axis] <= plane ? lower : upper;
            for (int k = 0; k < 3; ++k) {
                ASSERT_LE(bounds.lo[k], point[k] + margin);
                ASSERT_GE(bounds.hi[k], point[k] - margin);
            }
        }
    }
}

TEST(Cut, never_rounds_inwards) {
    const TriangleCorners triangle = {{0, 0, 0}, {1, 0.1f, 0.3f}, {0.7f, 1, 0.9f}};
    const Box part = cut(triangle, triangle.bounds(), 0, 0.1f).upper;
    // On the edge from a to b: y = 0.1 x exactly as these floats say.
    const double y_at_lo = double(0.1f) * double(0.1f);
    EXPECT_LE(part.lo.y, y_at_lo);
    EXPECT_GT(std::nextafter(part.lo.y, 1.0f), y_at_lo);
}

TEST(ParallelFor, calls_once_for_each) {
    for (const unsigned threads : {1u, 2u, 7u}) {
        std::vector<std::atomic<int>> calls(1000);
        parallel_for(calls.size(), threads, [&](size_t i, unsigned thread) {
            EXPECT_LT(thread, threads);
            ++calls[i];
        });
        EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](const auto &count) { return count == 1; }));
    }
}

TEST(ParallelFor, rethrows_and_stops) {
    std::atomic<size_t> calls = 0;
    const auto fail_early = [&](size_t i, unsigned) {
        ++calls;
        if (i == 3) throw std::bad_alloc();
    };
    EXPECT_THROW(parallel_for(100'000'000, 2, fail_early), std::bad_alloc);
    EXPECT_LT(calls, 100'000'000u);
}

} // namespace
} // namespace glint::test
