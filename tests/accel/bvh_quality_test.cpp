// That the hierarchy's builder looks for cheap trees: what it changes after splitting from the top down.
#include <functional>

#include <gtest/gtest.h>

#include "accel/bvh/binary_bvh.hpp"
#include "accel/bvh/collapse.hpp"
#include "accel/bvh/reinsertion.hpp"
#include "support/meshes.hpp"

namespace glint::test {
namespace {

using Visit = std::function<void(const BinaryNode &, uint32_t depth)>;

void walk(const BinaryBvh &bvh, uint32_t number, uint32_t depth, const Visit &visit) {
    const BinaryNode &node = bvh.nodes.at(number);
    visit(node, depth);
    if (node.is_leaf()) return;
    walk(bvh, node.first, depth + 1, visit);
    walk(bvh, node.first + 1, depth + 1, visit);
}

/// What a random ray that meets the scene passes through (MacDonald & Booth 1990).
double expected_nodes(const BinaryBvh &bvh) {
    double area = 0.0;
    walk(bvh, 0, 0, [&](const BinaryNode &node, uint32_t) { area += double(node.half_area()); });
    return area / double(bvh.nodes[0].half_area());
}

/// Many small triangles and a few as long as the scene, which top-down splits leave among the small ones.
std::vector<TriangleCorners> grass_with_poles() {
    std::vector<TriangleCorners> triangles;
    auto random = [state = 1u]() mutable {
        state = state * 1664525u + 1013904223u;
        return static_cast<float>(state >> 8) * 0x1p-24f;
    };
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 at{random() * 100.0f, 0.0f, random() * 100.0f};
        triangles.push_back({at, {at.x + 0.1f, 0.0f, at.z}, {at.x, 0.3f, at.z + 0.1f}});
    }
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 a{random() * 100.0f, 1.0f, random() * 100.0f}, b{random() * 100.0f, 1.0f, random() * 100.0f};
        triangles.push_back({a, b, {b.x, 1.1f, b.z}});
    }
    return triangles;
}

TEST(Reinsertion, makes_a_tree_cheaper_that_splits_left_poor) {
    const auto triangles = grass_with_poles();
    BinaryBvh bvh = build_binary_bvh(triangles, 1);
    const double before = expected_nodes(bvh);
    reinsert_large_nodes(bvh);
    EXPECT_LT(expected_nodes(bvh), 0.96 * before);
}

TEST(Reinsertion, keeps_a_tree_whole) {
    const auto triangles = grass_with_poles();
    BinaryBvh bvh = build_binary_bvh(triangles, 1);
    reinsert_large_nodes(bvh);
    std::vector<int> listed(triangles.size(), 0);
    walk(bvh, 0, 0, [&](const BinaryNode &node, uint32_t depth) {
        EXPECT_LE(depth, max_binary_depth);
        const auto within = [&](const BinaryNode &inner) {
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(inner.lo[axis], node.lo[axis]);
                EXPECT_LE(inner.hi[axis], node.hi[axis]);
            }
        };
        if (!node.is_leaf()) {
            within(bvh.nodes[node.first]);
            within(bvh.nodes[node.first + 1]);
            return;
        }
        for (uint32_t i = node.first; i < node.first + node.count; ++i) {
            const uint32_t id = bvh.triangle_ids.at(i);
            ++listed[id];
            const Box box = triangles[id].bounds();
            within({{box.lo.x, box.lo.y, box.lo.z}, 0, {box.hi.x, box.hi.y, box.hi.z}, 1});
        }
    });
    EXPECT_EQ(std::count(listed.begin(), listed.end(), 1), static_cast<std::ptrdiff_t>(listed.size()));
}

TEST(Reinsertion, stays_within_the_depth) {
    // A chain as deep as it may be, whose outermost links would best hang below the innermost.
    BinaryBvh bvh;
    const auto box = [](float size) { return BinaryNode{{0, 0, 0}, 0, {size, size, size}, 1}; };
    bvh.nodes.push_back(box(1000.0f));
    uint32_t inner = 0;
    for (uint32_t depth = 1; depth <= max_binary_depth; ++depth) {
        const auto first = static_cast<uint32_t>(bvh.nodes.size());
        bvh.nodes[inner].first = first;
        bvh.nodes[inner].count = 0;
        bvh.nodes.push_back(box(1000.0f - static_cast<float>(depth)));
        bvh.nodes.push_back(box(static_cast<float>(depth)));
        inner = first;
    }
    const double before = expected_nodes(bvh);
    for (int i = 0; i < 20; ++i) reinsert_large_nodes(bvh);
    EXPECT_LT(expected_nodes(bvh), before);
    uint32_t deepest = 0;
    walk(bvh, 0, 0, [&](const BinaryNode &, uint32_t depth) { deepest = std::max(deepest, depth); });
    EXPECT_LE(deepest, max_binary_depth);
}

class CollapseOfEveryMesh : public testing::TestWithParam<NamedMesh> {};

TEST_P(CollapseOfEveryMesh, leaves_no_node_that_fits_into_the_one_above) {
    const WideBvh bvh = build_wide_bvh(TriangleData::from(*scene_of(GetParam().mesh)).corners, 1);
    const auto count = [](const WideNode &node) {
        return std::count_if(std::begin(node.child), std::end(node.child), [](uint32_t link) { return link != 0; });
    };
    for (const WideNode &node : bvh.nodes) {
        for (const uint32_t word : node.child) {
            const ChildLink link(word);
            if (word == 0 || link.is_leaf()) continue;
            EXPECT_GT(count(node) - 1 + count(bvh.nodes.at(link.number())), WideNode::width)
                << "one node less would do";
        }
    }
}

TEST_P(CollapseOfEveryMesh, costs_no_more_than_opening_the_largest_child_first) {
    const BinaryBvh binary = build_binary_bvh(TriangleData::from(*scene_of(GetParam().mesh)).corners, 1);
    using Children = std::array<uint32_t, WideNode::width>;
    using Choice = std::function<uint32_t(uint32_t, Children &)>;
    const auto area_of = [&](const Choice &choose) {
        const std::function<double(uint32_t)> area = [&](uint32_t root) {
            if (binary.nodes[root].is_leaf()) return 0.0;
            Children children;
            const uint32_t count = choose(root, children);
            double sum = double(binary.nodes[root].half_area());
            for (uint32_t i = 0; i < count; ++i) sum += area(children[i]);
            return sum;
        };
        return area(0);
    };
    const auto largest_first = [&](uint32_t root, Children &children) {
        children[0] = root;
        uint32_t count = 1;
        while (count < WideNode::width) {
            const auto larger = [&](uint32_t a, uint32_t b) {
                const BinaryNode &x = binary.nodes[a], &y = binary.nodes[b];
                return (x.is_leaf() ? -1.0f : x.half_area()) < (y.is_leaf() ? -1.0f : y.half_area());
            };
            uint32_t &largest = *std::max_element(children.begin(), children.begin() + count, larger);
            if (binary.nodes[largest].is_leaf()) break;
            const uint32_t first = binary.nodes[largest].first;
            largest = first;
            children[count++] = first + 1;
        }
        return count;
    };
    const Collapse collapse(binary);
    const auto cheapest = [&](uint32_t root, Children &children) { return collapse.children_of(root, children); };
    EXPECT_LE(area_of(cheapest), area_of(largest_first) * 1.0001);
}

INSTANTIATE_TEST_SUITE_P(meshes, CollapseOfEveryMesh, testing::ValuesIn(all_meshes()),
                         [](const auto &test) { return test.param.name; });

} // namespace
} // namespace glint::test
