// How problems are put into words.
#include <glint/result.hpp>

#include <gtest/gtest.h>

namespace glint::test {
namespace {

Diagnostic sample() {
    Diagnostic diagnostic;
    diagnostic.file = "room.sdl";
    diagnostic.line = 3;
    diagnostic.column = 5;
    diagnostic.message = "found 'x', expected a number";
    diagnostic.source_line = "eye x 0 0";
    return diagnostic;
}

TEST(DiagnosticText, points_at_the_place) {
    EXPECT_EQ(sample().text(), "room.sdl:3:5: error: found 'x', expected a number\n"
                               "    eye x 0 0\n"
                               "        ^");
}

TEST(DiagnosticText, leaves_out_what_is_not_known) {
    Diagnostic diagnostic;
    diagnostic.severity = Diagnostic::Severity::warning;
    diagnostic.message = "no light";
    EXPECT_EQ(diagnostic.text(), "warning: no light");
    diagnostic.file = "room.sdl";
    EXPECT_EQ(diagnostic.text(), "room.sdl: warning: no light");
    diagnostic.hint = "add a 'light' line";
    EXPECT_EQ(diagnostic.text(), "room.sdl: warning: no light\n    add a 'light' line");
}

TEST(DiagnosticText, cuts_long_lines_around_the_column) {
    Diagnostic diagnostic = sample();
    diagnostic.source_line = std::string(5000, 'a') + "X" + std::string(5000, 'b');
    diagnostic.column = 5001;
    const std::string text = diagnostic.text();
    EXPECT_LT(text.size(), 400u);
    const std::string shown = text.substr(text.find('\n') + 1);
    EXPECT_EQ(shown.find('X'), shown.substr(shown.find('\n') + 1).find('^'));
}

TEST(DiagnosticText, never_passes_control_bytes_on) {
    Diagnostic diagnostic = sample();
    diagnostic.source_line = "eye\t\x1b[31mx\x07 0 0";
    for (const char c : diagnostic.text()) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
}

TEST(ErrorText, lists_every_diagnostic) {
    const Error error(ErrorCode::bad_input, {sample(), sample()});
    EXPECT_EQ(error.text(), sample().text() + "\n" + sample().text());
}

} // namespace
} // namespace glint::test
