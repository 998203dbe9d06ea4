// Putting messages together.
#include "text/words.hpp"

#include <gtest/gtest.h>

namespace glint::test {
namespace {

using std::string_view_literals::operator""sv;

TEST(Quotes, show_what_a_terminal_must_not_get) {
    EXPECT_EQ(in_quotes("eye"), "'eye'");
    EXPECT_EQ(in_quotes("\x1b[31m"), "'\\x1b[31m'");
    EXPECT_EQ(in_quotes("a\0b"sv), "'a\\x00b'");
    EXPECT_EQ(in_quotes("caf\u00e9"), "'caf\u00e9'");
    EXPECT_EQ(in_quotes("caf\xe9"), "'caf\\xe9'");
    EXPECT_EQ(in_quotes("\x7f"), "'\\x7f'");
}

TEST(Quotes, cut_what_is_long_between_characters) {
    EXPECT_EQ(in_quotes(std::string(1000, 'x')), "'" + std::string(48, 'x') + "...'");
    EXPECT_EQ(in_quotes(std::string(47, 'x') + "\u00e9y"), "'" + std::string(47, 'x') + "\u00e9...'");
    EXPECT_EQ(in_quotes(std::string(48, 'x')), "'" + std::string(48, 'x') + "'");
}

TEST(Quotes, show_the_whole_of_a_path) {
    EXPECT_EQ(path_in_quotes(std::string(200, 'x') + ".obj"), "'" + std::string(200, 'x') + ".obj'");
}

TEST(LowerCase, changes_the_letters_of_ascii_alone) {
    EXPECT_EQ(lower_case("Max_DEPTH 3"), "max_depth 3");
    EXPECT_EQ(lower_case("\u00c9@[`{\xff"), "\u00c9@[`{\xff");
}

TEST(Utf8, takes_what_unicode_allows) {
    EXPECT_EQ(utf8_length("A"), 1u);
    EXPECT_EQ(utf8_length("\u00e9"), 2u);
    EXPECT_EQ(utf8_length("\u20ac"), 3u);
    EXPECT_EQ(utf8_length("\U0001f600"), 4u);
    EXPECT_EQ(utf8_length("\xf4\x8f\xbf\xbf"), 4u);
}

TEST(Utf8, refuses_what_unicode_forbids) {
    for (const auto bad :
         {"\x80"sv, "\xff"sv, "\xc3"sv, "\xc3("sv, "\xc0\x80"sv, "\xc1\xbf"sv, "\xe0\x9f\xbf"sv, "\xed\xa0\x80"sv,
          "\xe2\x82"sv, "\xf0\x8f\xbf\xbf"sv, "\xf4\x90\x80\x80"sv, "\xf5\x80\x80\x80"sv, "\xf0\x9f\x98"sv}) {
        EXPECT_EQ(utf8_length(bad), 0u) << in_quotes(bad);
    }
}

TEST(Words, are_put_together) {
    EXPECT_EQ(words("a ", 1, ' ', std::string("b"), uint64_t{2}), "a 1 b2");
    EXPECT_EQ(counted(1, "triangle"), "1 triangle");
    EXPECT_EQ(counted(0, "triangle"), "0 triangles");
}

} // namespace
} // namespace glint::test
