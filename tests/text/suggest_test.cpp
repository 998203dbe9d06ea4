// "Did you mean".
#include "text/suggest.hpp"

#include <string>

#include <gtest/gtest.h>

namespace glint::test {
namespace {

TEST(EditDistance, counts_single_edits) {
    EXPECT_EQ(edit_distance("eye", "eye"), 0u);
    EXPECT_EQ(edit_distance("", "eye"), 3u);
    EXPECT_EQ(edit_distance("obect", "object"), 1u);
    EXPECT_EQ(edit_distance("objject", "object"), 1u);
    EXPECT_EQ(edit_distance("objekt", "object"), 1u);
    EXPECT_EQ(edit_distance("ojbect", "object"), 1u);
    EXPECT_EQ(edit_distance("size", "eye"), 3u);
    EXPECT_GT(edit_distance(std::string(33, 'a'), "a"), 1000u);
}

TEST(NearestWord, is_within_two_edits) {
    const std::vector<std::string_view> known = {"eye", "size", "object", "max_depth"};
    EXPECT_EQ(nearest_word("obejct", known), "object");
    EXPECT_EQ(nearest_word("maxdeph", known), "max_depth");
    EXPECT_EQ(nearest_word("eyes", known), "eye");
    EXPECT_EQ(nearest_word("sphere", known), std::nullopt);
    EXPECT_EQ(nearest_word("x", known), std::nullopt);
    EXPECT_EQ(nearest_word("", known), std::nullopt);
}

} // namespace
} // namespace glint::test
