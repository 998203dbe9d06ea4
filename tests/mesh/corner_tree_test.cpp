// The tree over a polygon's corners finds what looking at every corner finds.
#include "mesh/corner_tree.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace glint::test {
namespace {

bool is_in(const glm::dvec2 &p, const glm::dvec2 (&t)[3]) {
    return turn(t[0], t[1], p) >= 0.0 && turn(t[1], t[2], p) >= 0.0 && turn(t[2], t[0], p) >= 0.0;
}

glm::dvec2 somewhere(Random &random) {
    // Few distinct coordinates, so that many corners lie on a triangle's very edge.
    return {random.below(64), random.below(64)};
}

TEST(CornerTree, finds_what_looking_at_every_corner_finds) {
    Random random(3);
    std::vector<glm::dvec2> places;
    std::vector<uint8_t> left;
    for (int i = 0; i < 500; ++i) {
        places.push_back(somewhere(random));
        left.push_back(random.below(4) > 0);
    }
    CornerTree tree;
    tree.build(places, left);
    uint64_t asked = 0, found = 0, queries = 0;
    while (std::find(left.begin(), left.end(), 1) != left.end()) {
        for (int i = 0; i < 20; ++i) {
            glm::dvec2 t[3] = {somewhere(random), somewhere(random), somewhere(random)};
            if (turn(t[0], t[1], t[2]) < 0.0) std::swap(t[1], t[2]);
            std::vector<uint8_t> seen(places.size());
            const auto note = [&](uint32_t corner) { return ++asked, seen[corner] = 1, false; };
            EXPECT_FALSE(tree.any_near(t[0], t[1], t[2], note));
            const auto is_left_and_in = [&](uint32_t corner) { return left[corner] && is_in(places[corner], t); };
            bool any = false;
            for (uint32_t k = 0; k < places.size(); ++k) {
                if (!is_left_and_in(k)) continue;
                EXPECT_TRUE(seen[k]) << "corner " << k;
                any = true;
            }
            EXPECT_EQ(tree.any_near(t[0], t[1], t[2], is_left_and_in), any);
            found += any;
            ++queries;
        }
        const uint32_t gone = random.below(static_cast<uint32_t>(places.size()));
        if (left[gone]) tree.remove(gone);
        left[gone] = 0;
    }
    EXPECT_GT(found, queries / 10);
    EXPECT_LT(asked, queries * places.size() / 10) << "no better than looking at every corner";
}

TEST(CornerTree, passes_by_corners_in_a_row_beside_a_long_triangle) {
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 10000; ++i) places.emplace_back(i, 0.0);
    CornerTree tree;
    tree.build(places, std::vector<uint8_t>(places.size(), 1));
    int asked = 0;
    const auto count = [&](uint32_t) { return ++asked, false; };
    EXPECT_FALSE(tree.any_near({0, -1}, {9999, -1}, {9999, 0}, count));
    EXPECT_GE(asked, 1);
    EXPECT_LE(asked, 64);
}

TEST(CornerTree, may_be_empty) {
    CornerTree tree;
    const auto never = [](uint32_t) { return true; };
    EXPECT_FALSE(tree.any_near({0, 0}, {1, 0}, {0, 1}, never));
    tree.build({{0, 0}, {1, 1}}, {0, 0});
    EXPECT_FALSE(tree.any_near({0, 0}, {1, 0}, {0, 1}, never));
}

} // namespace
} // namespace glint::test
