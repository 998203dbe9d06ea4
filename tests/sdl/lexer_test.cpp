// From text to lines of words.
#include "sdl/lexer.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace glint::test {
namespace {

/// "number:column word word ..." for each line with words.
std::vector<std::string> lines_of(std::string_view text, Problems *problems = nullptr) {
    std::vector<std::string> lines;
    Lexer lexer(text, problems);
    Line line;
    while (lexer.next(line)) {
        std::string shown = std::to_string(line.number) + ':' + std::to_string(line.tokens[0].column);
        for (const Token &token : line.tokens) shown += ' ' + std::string(token.text);
        lines.push_back(shown);
        EXPECT_EQ(line.argument_count, line.tokens.size() - 1);
    }
    return lines;
}

using Lines = std::vector<std::string>;

TEST(Lexer, splits_lines_at_blanks_and_tabs) {
    EXPECT_EQ(lines_of("eye 0 0 5.7\n \t size\t256  256 \n"), (Lines{"1:1 eye 0 0 5.7", "2:4 size 256 256"}));
}

TEST(Lexer, ends_lines_as_any_system_does) {
    EXPECT_EQ(lines_of("a 1\nb 2\n"), (Lines{"1:1 a 1", "2:1 b 2"}));
    EXPECT_EQ(lines_of("a 1\r\nb 2\r\n"), (Lines{"1:1 a 1", "2:1 b 2"}));
    EXPECT_EQ(lines_of("a 1\rb 2"), (Lines{"1:1 a 1", "2:1 b 2"}));
    EXPECT_EQ(lines_of("a\n\r\n\rb"), (Lines{"1:1 a", "4:1 b"}));
}

TEST(Lexer, drops_comments_and_empty_lines) {
    EXPECT_EQ(lines_of("# eye 1 2 3\n\n   \n  # x\neye 0#1 2\n#"), (Lines{"5:1 eye 0"}));
    EXPECT_EQ(lines_of(""), Lines{});
}

TEST(Lexer, points_to_bytes_of_the_source_line) {
    Lexer lexer("\n  light  lamp.obj # here\r\n");
    Line line;
    ASSERT_TRUE(lexer.next(line));
    EXPECT_EQ(line.source, "  light  lamp.obj # here");
    const Place place = line.place(line.tokens[1]);
    EXPECT_EQ(place.line, 2u);
    EXPECT_EQ(place.column, 10u);
    EXPECT_EQ(place.source_line, line.source);
}

TEST(Lexer, counts_words_beyond_those_it_keeps) {
    std::string text = "object";
    for (int i = 0; i < 1000; ++i) text += " 1";
    Lexer lexer(text);
    Line line;
    ASSERT_TRUE(lexer.next(line));
    EXPECT_EQ(line.tokens.size(), Line::most_tokens);
    EXPECT_EQ(line.argument_count, 1000u);
}

TEST(Lexer, reports_text_that_is_not_utf8_once_a_line) {
    Problems problems("room.sdl");
    EXPECT_EQ(lines_of("# caf\xc3\xa9\n# caf\xe9 \xe9\neye 0\n", &problems), (Lines{"3:1 eye 0"}));
    const Error error = problems.take_error();
    ASSERT_EQ(error.diagnostics.size(), 1u);
    EXPECT_EQ(error.diagnostics[0].line, 2u);
    EXPECT_EQ(error.diagnostics[0].column, 6u);
    EXPECT_EQ(error.diagnostics[0].message, "byte '\\xe9' is not UTF-8");
    EXPECT_EQ(error.diagnostics[0].hint, "save the file as UTF-8 or ASCII");
}

TEST(Lexer, reports_what_only_looks_like_a_blank_and_goes_on_as_if_it_were) {
    Problems problems("room.sdl");
    EXPECT_EQ(lines_of("eye\u00a00 # no-break spaces\u00a0in comments are fine\nsize \ufeff4\n# \u00a0\n", &problems),
              (Lines{"1:1 eye 0", "2:1 size 4"}));
    const Error error = problems.take_error();
    ASSERT_EQ(error.diagnostics.size(), 2u);
    EXPECT_EQ(error.diagnostics[0].message, "there is a no-break space (U+00A0)");
    EXPECT_EQ(error.diagnostics[0].column, 4u);
    EXPECT_EQ(error.diagnostics[1].line, 2u);
    EXPECT_EQ(error.diagnostics[1].message, "there is a byte-order mark (U+FEFF) inside the file");
}

TEST(Lexer, does_not_take_a_number_of_microsoft_s_for_a_comment) {
    EXPECT_EQ(lines_of("eye 0 1.#INF -1.#IND #1.#INF\neye 1.#5\n"), (Lines{"1:1 eye 0 1.#INF -1.#IND", "2:1 eye 1."}));
}

} // namespace
} // namespace glint::test
