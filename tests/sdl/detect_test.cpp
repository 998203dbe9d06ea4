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

/// A text, and the dialect that detection finds, with its reason.
struct Found {
    std::string text;
    std::string dialect;
    std::string reason;
};

/// A text, and the words that detection refuses it with.
struct Refused {
    std::string text;
    uint32_t line;
    std::string error;
    std::string hint;
};

/// How a test's parameter is printed: the text's first line.
std::ostream &operator<<(std::ostream &out, const Found &one) {
    return out << one.text.substr(0, one.text.find('\n'));
}
std::ostream &operator<<(std::ostream &out, const Refused &one) {
    return out << one.text.substr(0, one.text.find('\n'));
}

class Detection : public ::testing::TestWithParam<Found> {};

TEST_P(Detection, finds_the_dialect_and_says_why) {
    const Found &expected = GetParam();
    Problems problems("room.sdl");
    const auto detected = detect_dialect(expected.text, {}, problems);
    ASSERT_TRUE(detected) << problems.take_error().text();
    EXPECT_EQ(dialect_name(detected->dialect), expected.dialect);
    EXPECT_EQ(detected->reason, expected.reason);
    EXPECT_TRUE(problems.ok());
}

INSTANTIATE_TEST_SUITE_P(
    Of, Detection,
    ::testing::Values(
        // One dialect's own words.
        Found{"eye 0 0 1\nmax_depth 1\n" + object9, "mobile2013", "'max_depth' on line 2"},
        Found{object9 + "MAX_DEPTH\n", "mobile2013", "'max_depth' on line 2"},
        Found{"light a.obj 1 1 1 1\nmax_depth 1\n", "mobile2013", "'max_depth' on line 2"},
        Found{"maxdepth 1\n", "cg-path-tracer", "'maxdepth' on line 1"},
        Found{"\nlightpoint 0 0 0 1 1 1 1\n", "cg-path-tracer", "'lightpoint' on line 2"},
        Found{"lightarea a.obj 1 1 1 1\n", "cg-path-tracer", "'lightarea' on line 1"},
        Found{"lightresolution 4 4\n", "cg-path-tracer", "'lightresolution' on line 1"},
        Found{object13, "cg-path-tracer", "'object' with 13 numbers on line 1"},
        Found{"profundidade 1\n", "ray2005", "'profundidade' on line 1"},
        Found{"supersample on\n", "ray2005", "'supersample' on line 1"},
        Found{"light 0 1 0 0.5\n", "ray2005", "'light' with 4 numbers on line 1"},
        Found{"object" + numbers20 + "light 0 1 0 0.5\n", "ray2005", "'light' with 4 numbers on line 2"},
        Found{object8, "path2005", "'object' with 8 numbers on line 1"},
        Found{object9 + object8, "path2005", "'object' with 8 numbers on line 2"},
        Found{"quadric" + numbers18, "path2005", "'quadric' on line 1"},
        Found{"quadric" + numbers18 + "dialect raycife\n", "raycife", "'dialect' on line 2"},
        Found{"objectquadric" + numbers18, "path2005", "'objectquadric' with 18 numbers on line 1"},
        Found{"light a.obj 1 1 1 1 0 0 0\n", "raycife", "'light' with 7 numbers on line 1"},
        Found{"light a.obj 1 1 1 1 0 0 0\nnpaths 1\n" + object9, "raycife", "'light' with 7 numbers on line 1"},
        // Words that only together leave one dialect.
        Found{"npaths 10\n" + object9, "path2005", "'npaths' on line 1 and 'object' with 9 numbers on line 2"},
        Found{"seed 1\n" + object9, "path2005", "'seed' on line 1 and 'object' with 9 numbers on line 2"},
        Found{"tonemapping 1\n" + object9, "path2005", "'tonemapping' on line 1 and 'object' with 9 numbers on line 2"},
        Found{"tonemapping 1\nobjectquadric" + numbers20, "cg-path-tracer",
              "'tonemapping' on line 1 and 'objectquadric' with 20 numbers on line 2"},
        // One word that does alone, among others that do not.
        Found{"npaths 1\n" + object13 + "lightpoint 0 0 0 1 1 1 1\n", "cg-path-tracer",
              "'object' with 13 numbers on line 2"},
        Found{"objectquadric" + numbers20 + "supersample on\n", "ray2005", "'supersample' on line 2"},
        // The file says so itself.
        Found{object9 + "dialect mobile2013\n", "mobile2013", "'dialect' on line 2"},
        Found{object9 + "supersample on\nDialect mobile2013\n", "mobile2013", "'dialect' on line 3"},
        Found{"max_depth 1\ndialect path2005\n", "path2005", "'dialect' on line 2"},
        Found{"dialect ray2005\ndialect raycife\n", "ray2005", "'dialect' on line 1"},
        Found{"dialect cg-path-tracer\n", "cg-path-tracer", "'dialect' on line 1"},
        Found{"dialect glint\n" + object13 + "light x.obj 1 1 1 1 0 0 0\n", "glint", "'dialect' on line 1"},
        // What shows nothing.
        Found{"", "mobile2013", "no line shows another dialect"},
        Found{"eye 0 0 1\nlight a.obj 1 1 1 1\nlight a.obj 1 1 1\nobject a.obj 1\nshere\nreflections 1\n", "mobile2013",
              "no line shows another dialect"},
        Found{"nshadowrays 4\nsamples 4\nfov 60\nlight_point 0 0 0 1 1 1 1\n", "mobile2013",
              "no line shows another dialect"}));

class Refusal : public ::testing::TestWithParam<Refused> {};

TEST_P(Refusal, says_what_speaks_for_what) {
    const Refused &expected = GetParam();
    Problems problems("room.sdl");
    ASSERT_FALSE(detect_dialect(expected.text, {}, problems));
    const Error error = problems.take_error();
    ASSERT_EQ(error.diagnostics.size(), 1u);
    EXPECT_EQ(error.diagnostics[0].message, expected.error);
    EXPECT_EQ(error.diagnostics[0].line, expected.line);
    EXPECT_EQ(error.diagnostics[0].hint, expected.hint);
}

INSTANTIATE_TEST_SUITE_P(
    Of, Refusal,
    ::testing::Values(
        Refused{"eye 0 0 1\n" + object9, 2,
                "'object' with 9 numbers can be read as mobile2013 (file.obj r g b ka kd ks ke kr kt) or as path2005 "
                "(file.obj r g b ka kd ks kt n [ior])",
                "a line 'dialect mobile2013' or 'dialect path2005' settles it"},
        Refused{"objectquadric" + numbers20, 1,
                "'objectquadric' with 20 numbers can be read as ray2005 or cg-path-tracer",
                "a line 'dialect ray2005' or 'dialect cg-path-tracer' settles it; scenes/sdl/README.md says how they "
                "differ"},
        Refused{"npaths 10\n", 1, "'npaths' can be read as path2005 or cg-path-tracer",
                "a line 'dialect path2005' or 'dialect cg-path-tracer' settles it; scenes/sdl/README.md says how they "
                "differ"},
        Refused{"max_depth 1\nnpaths 3\n", 2,
                "the file mixes dialects: 'max_depth' on line 1 is mobile2013, 'npaths' on line 2 is path2005, "
                "cg-path-tracer or raycife",
                "if it is one of them, a first line such as 'dialect mobile2013' or 'dialect path2005' settles it"},
        Refused{object9 + "eye 0 0 1\nlightpoint 0 0 0 1 1 1 1\nmax_depth 1\n", 3,
                "the file mixes dialects: 'object' with 9 numbers on line 1 is mobile2013, path2005 or raycife, "
                "'lightpoint' on line 3 is cg-path-tracer",
                "if it is one of them, a first line such as 'dialect mobile2013' or 'dialect cg-path-tracer' settles "
                "it"},
        Refused{"quadric" + numbers18 + "light 0 0 0 1\n", 2,
                "the file mixes dialects: 'quadric' on line 1 is path2005 or raycife, 'light' with 4 numbers on line 2 "
                "is ray2005",
                "if it is one of them, a first line such as 'dialect path2005' or 'dialect ray2005' settles it"},
        // The line between the two that contradict each other is not told of.
        Refused{object9 + "npaths 2\nobjectquadric" + numbers20, 3,
                "the file mixes dialects: 'object' with 9 numbers on line 1 is mobile2013, path2005 or raycife, "
                "'objectquadric' with 20 numbers on line 3 is ray2005 or cg-path-tracer",
                "if it is one of them, a first line such as 'dialect mobile2013' or 'dialect ray2005' settles it"},
        Refused{"dialect mobil2013\n", 1, "there is no dialect 'mobil2013'", "did you mean 'mobile2013'?"},
        Refused{"dialect pov\n", 1, "there is no dialect 'pov'",
                "the dialects are mobile2013, path2005, ray2005, cg-path-tracer, raycife, glint"}));

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
