// Which dialect a file is taken for.
#include "sdl/detect.hpp"

#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace glint::test {
namespace {

const std::string object8 = "object a.obj 1 1 1 1 0 0 0 1\n";
const std::string object9 = "object a.obj 1 1 1 1 0 0 0 0 0\n";
const std::string object13 = "object a.obj 0 0 0 1 1 1 1 0 0 1 0 0 1\n";
const std::string numbers20 = " 1 1 1 0 0 0 0 0 0 -1 1 1 1 1 0 0 1 0 0 1\n";
const std::string numbers18 = " 1 1 1 0 0 0 0 0 0 -1 1 1 1 1 0 0 1 0\n";

/// A text, and the dialect that detection finds or the words it refuses with.
struct Case {
    std::string text;
    std::string reason;
    std::string error = {};
    uint32_t error_line = 0;
};

/// How a test's parameter is printed: the text's first line.
std::ostream &operator<<(std::ostream &out, const Case &one) {
    return out << one.text.substr(0, one.text.find('\n'));
}

std::string other(const std::string &dialect, const std::string &reason) {
    return "this version of Glint reads the dialect mobile2013, and the file is " + dialect + " (" + reason + ")";
}

class Detection : public ::testing::TestWithParam<Case> {};

TEST_P(Detection, finds_the_dialect_or_says_why_not) {
    const Case &expected = GetParam();
    Problems problems("room.sdl");
    const auto detected = detect_dialect(expected.text, {}, problems);
    if (expected.error.empty()) {
        ASSERT_TRUE(detected) << problems.take_error().text();
        EXPECT_EQ(detected->dialect, Dialect::mobile2013);
        EXPECT_EQ(detected->reason, expected.reason);
        EXPECT_TRUE(problems.ok());
    } else {
        ASSERT_FALSE(detected);
        const Error error = problems.take_error();
        ASSERT_EQ(error.diagnostics.size(), 1u);
        EXPECT_EQ(error.diagnostics[0].message, expected.error);
        EXPECT_EQ(error.diagnostics[0].line, expected.error_line);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, Detection,
    ::testing::Values(
        // One dialect's own words.
        Case{"eye 0 0 1\nmax_depth 1\n" + object9, "'max_depth' on line 2"},
        Case{object9 + "MAX_DEPTH\n", "'max_depth' on line 2"},
        Case{"light a.obj 1 1 1 1\nmax_depth 1\n", "'max_depth' on line 2"},
        Case{"maxdepth 1\n", "", other("cg-path-tracer", "'maxdepth' on line 1"), 1},
        Case{"\nlightpoint 0 0 0 1 1 1 1\n", "", other("cg-path-tracer", "'lightpoint' on line 2"), 2},
        Case{"lightarea a.obj 1 1 1 1\n", "", other("cg-path-tracer", "'lightarea' on line 1"), 1},
        Case{"lightresolution 4 4\n", "", other("cg-path-tracer", "'lightresolution' on line 1"), 1},
        Case{object13, "", other("cg-path-tracer", "'object' with 13 numbers on line 1"), 1},
        Case{"profundidade 1\n", "", other("ray2005", "'profundidade' on line 1"), 1},
        Case{"supersample on\n", "", other("ray2005", "'supersample' on line 1"), 1},
        Case{"light 0 1 0 0.5\n", "", other("ray2005", "'light' with 4 numbers on line 1"), 1},
        Case{"npaths 10\n", "", other("path2005", "'npaths' on line 1"), 1},
        Case{"tonemapping 1\n", "", other("path2005", "'tonemapping' on line 1"), 1},
        Case{"seed 1\n", "", other("path2005", "'seed' on line 1"), 1},
        Case{object8, "", other("path2005", "'object' with 8 numbers on line 1"), 1},
        Case{object9 + object8, "", other("path2005", "'object' with 8 numbers on line 2"), 2},
        Case{"quadric" + numbers18, "", other("path2005", "'quadric' on line 1"), 1},
        Case{"objectquadric" + numbers18, "", other("path2005", "'objectquadric' with 18 numbers on line 1"), 1},
        Case{"light a.obj 1 1 1 1 0 0 0\n", "", other("raycife", "'light' with 7 numbers on line 1"), 1},
        // Two words that together leave one dialect.
        Case{"object" + numbers20 + "supersample on\n", "", other("ray2005", "'supersample' on line 2"), 2},
        // The file says so itself.
        Case{object9 + "dialect mobile2013\n", "'dialect' on line 2"},
        Case{object9 + "supersample on\nDialect mobile2013\n", "'dialect' on line 3"},
        Case{"max_depth 1\ndialect path2005\n", "", other("path2005", "'dialect' on line 2"), 2},
        Case{"dialect mobil2013\n", "", "there is no dialect 'mobil2013'", 1},
        // What shows nothing.
        Case{"", "no line shows another dialect"},
        Case{"eye 0 0 1\nlight a.obj 1 1 1 1\nlight a.obj 1 1 1\nobject a.obj 1\nshere\nreflections 1\n",
             "no line shows another dialect"},
        // Several readings.
        Case{"eye 0 0 1\n" + object9, "",
             "'object' with 9 numbers can be read as mobile2013 (file.obj r g b ka kd ks ke kr kt) or as path2005 "
             "(file.obj r g b ka kd ks kt n [ior])",
             2},
        Case{"objectquadric" + numbers20, "",
             "'objectquadric' with 20 numbers can be read as ray2005 (a b c d e f g h j k r g b ka kd ks n kr kt ior) "
             "or as cg-path-tracer (a b c d e f g h j k r g b ka kd ks n kr kt ior)",
             1},
        // Contradictions.
        Case{"max_depth 1\nnpaths 3\n", "",
             "the file mixes dialects: 'max_depth' on line 1 is mobile2013, 'npaths' on line 2 is path2005", 2},
        Case{object9 + "eye 0 0 1\nlightpoint 0 0 0 1 1 1 1\nmax_depth 1\n", "",
             "the file mixes dialects: 'object' with 9 numbers on line 1 is mobile2013 or path2005, 'lightpoint' on "
             "line 3 is cg-path-tracer",
             3}));

TEST(DetectionHints, name_the_line_that_settles_it) {
    const auto hint = [](const std::string &text) {
        Problems problems("room.sdl");
        EXPECT_FALSE(detect_dialect(text, {}, problems));
        return problems.take_error().diagnostics.at(0).hint;
    };
    EXPECT_EQ(hint(object9), "a line 'dialect mobile2013' or 'dialect path2005' settles it");
    EXPECT_EQ(hint("max_depth 1\nnpaths 3\n"),
              "if it is one of them, a first line such as 'dialect mobile2013' or 'dialect path2005' settles it");
    EXPECT_EQ(hint("dialect mobil2013\n"), "did you mean 'mobile2013'?");
    EXPECT_EQ(hint("dialect pov\n"), "the dialects are mobile2013, path2005, ray2005, cg-path-tracer, raycife");
}

TEST(DetectionOptions, obeys_the_caller_before_the_file) {
    Problems problems("room.sdl");
    const auto detected = detect_dialect("dialect path2005\n", "mobile2013", problems);
    ASSERT_TRUE(detected);
    EXPECT_EQ(detected->dialect, Dialect::mobile2013);
    EXPECT_EQ(detected->reason, "the caller asked for it");
    const auto warnings = problems.take_warnings();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].message, "the file says dialect 'path2005' and is read as mobile2013, as the caller asked");
}

TEST(DetectionOptions, refuses_a_dialect_that_the_caller_made_up) {
    Problems problems("room.sdl");
    EXPECT_FALSE(detect_dialect("max_depth 1\n", "mobile2014", problems));
    EXPECT_EQ(problems.take_error().text(), "room.sdl: error: there is no dialect 'mobile2014'\n"
                                            "    did you mean 'mobile2013'?");
}

} // namespace
} // namespace glint::test
