// Collecting every problem of a file.
#include "text/problems.hpp"

#include <gtest/gtest.h>

#include "text/plain_text.hpp"

namespace glint::test {
namespace {

using std::string_view_literals::operator""sv;

TEST(Problems, carry_the_file_and_the_place) {
    Problems problems("room.sdl");
    problems.error({3, 5, "eye x 0 0"}, "message", "hint");
    const Error error = problems.take_error();
    EXPECT_EQ(error.code, ErrorCode::bad_input);
    EXPECT_EQ(error.text(), "room.sdl:3:5: error: message\n    eye x 0 0\n        ^\n    hint");
}

TEST(Problems, beyond_a_hundred_are_counted) {
    Problems problems("room.sdl");
    for (uint32_t i = 1; i <= 100; ++i) problems.error({i, 1, {}}, "wrong");
    EXPECT_TRUE(problems.full());
    problems.error({101, 1, {}}, "wrong");
    problems.error({102, 1, {}}, "wrong");
    const Error error = problems.take_error();
    ASSERT_EQ(error.diagnostics.size(), 101u);
    EXPECT_EQ(error.diagnostics[99].line, 100u);
    EXPECT_EQ(error.diagnostics[100].text(), "room.sdl: error: and 2 more problems");
}

TEST(Problems, of_one_kind_give_their_code_and_mixed_ones_are_bad_input) {
    Problems limits("a"), mixed("a");
    limits.error({}, "large", {}, ErrorCode::limit_exceeded);
    limits.error({}, "larger", {}, ErrorCode::limit_exceeded);
    EXPECT_EQ(limits.take_error().code, ErrorCode::limit_exceeded);
    mixed.error({}, "large", {}, ErrorCode::limit_exceeded);
    mixed.adopt(Error(ErrorCode::not_found, "missing"));
    EXPECT_EQ(mixed.take_error().code, ErrorCode::bad_input);
}

TEST(Problems, carry_no_endless_source_line) {
    const std::string line(10'000'000, 'x');
    Problems problems("a");
    problems.error({1, 10, line}, "near the start");
    problems.error({1, 9'000'000, line}, "far out");
    const Error error = problems.take_error();
    EXPECT_EQ(error.diagnostics[0].source_line.size(), 4096u);
    EXPECT_EQ(error.diagnostics[1].source_line, "");
    EXPECT_EQ(error.diagnostics[1].column, 9'000'000u);
}

TEST(PlainText, has_no_nul_byte) {
    Problems good("a"), bad("a"), wide("a");
    EXPECT_TRUE(check_is_text("eye 0 0 1\n", good));
    EXPECT_TRUE(good.ok());
    EXPECT_FALSE(check_is_text("eye\nsi\0ze\0"sv, bad));
    EXPECT_EQ(bad.take_error().text(), "a:2:3: error: this is not a text file: it has a NUL byte");
    EXPECT_FALSE(check_is_text("\xff\xfe"
                               "e\0y\0e\0"sv,
                               wide));
    EXPECT_EQ(wide.take_error().diagnostics[0].hint, "it looks like UTF-16: save it as UTF-8");
}

TEST(PlainText, may_begin_with_a_byte_order_mark) {
    EXPECT_EQ(without_byte_order_mark("\xef\xbb\xbf"
                                      "eye"),
              "eye");
    EXPECT_EQ(without_byte_order_mark("\xef\xbb"), "\xef\xbb");
}

} // namespace
} // namespace glint::test
