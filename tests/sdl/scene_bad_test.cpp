// Every way in which an SDL file is refused, with its words.
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/written_files.hpp"

namespace glint::test {
namespace {

/// A whole good scene of four lines, one of which a test replaces by its own.
constexpr const char *eye = "eye 0 0 5\n", *light = "light lamp.obj 1 1 1 1\n",
                     *object = "object wall.obj 1 1 1 0 1 0 0 0 0\n", *depth = "max_depth 1\n";

/// A text that has one problem, and where and what it is.
struct BadScene {
    const char *name;
    std::string text;
    uint32_t line, column;
    std::string message;
    std::string hint = {};
    ErrorCode code = ErrorCode::bad_input;
};

void PrintTo(const BadScene &bad, std::ostream *out) {
    *out << bad.name;
}

class SceneFiles : public WrittenFiles {
protected:
    void SetUp() override {
        WrittenFiles::SetUp();
        write("wall.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("lamp.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
    }
    [[nodiscard]] Error error_of(std::string_view text, const ReadOptions &options = {}) const {
        const auto scene = read_scene(write("bad.sdl", text), options);
        if (scene.ok()) throw std::runtime_error("was read:\n" + std::string(text));
        return scene.error();
    }
};

class BadScenes : public SceneFiles, public ::testing::WithParamInterface<BadScene> {};

TEST_P(BadScenes, are_refused_with_a_place_and_words) {
    const BadScene &bad = GetParam();
    const Error error = error_of(bad.text);
    ASSERT_EQ(error.diagnostics.size(), 1u) << error.text();
    EXPECT_EQ(error.code, bad.code);
    const Diagnostic &diagnostic = error.diagnostics[0];
    EXPECT_EQ(diagnostic.file, in_folder("bad.sdl").string());
    EXPECT_EQ(diagnostic.line, bad.line);
    EXPECT_EQ(diagnostic.column, bad.column);
    EXPECT_EQ(diagnostic.message, bad.message);
    EXPECT_EQ(diagnostic.hint, bad.hint);
    EXPECT_EQ(diagnostic.source_line.empty(), bad.line == 0);
}

std::string with_eye(const std::string &line) {
    return line + "\n" + light + object + depth;
}
std::string with_light(const std::string &line) {
    return line + "\n" + eye + object + depth;
}
std::string with_object(const std::string &line) {
    return line + "\n" + eye + light + depth;
}
std::string with_depth(const std::string &line) {
    return line + "\n" + eye + light + object + "dialect mobile2013\n";
}
std::string and_also(const std::string &line) {
    return line + "\n" + eye + light + object + depth;
}

const std::string from_0_to_1 = ", expected a number from 0 to 1";
const std::string object_usage = "expected: object file.obj r g b ka kd ks ke kr kt";

const BadScene bad_scenes[] = {
    // Words.
    {"unknown_directive", and_also("sphere 1 2 3"), 1, 1, "unknown directive 'sphere'"},
    {"one_edit", and_also("Backgroun 1 2 3"), 1, 1, "unknown directive 'Backgroun'", "did you mean 'background'?"},
    {"two_edits", and_also("ambeintt 1"), 1, 1, "unknown directive 'ambeintt'", "did you mean 'ambient'?"},
    {"escape_bytes", and_also("\x1b[31m"), 1, 1, "unknown directive '\\x1b[31m'"},
    {"not_utf8", and_also("# \xff"), 1, 3, "byte '\\xff' is not UTF-8", "save the file as UTF-8 or ASCII"},
    // Directives that others have.
    {"target", and_also("target 0 0 0"), 1, 1, "'target' is not supported by this version of Glint"},
    {"up", and_also("up 0 1 0"), 1, 1, "'up' is not supported by this version of Glint"},
    {"window_size", and_also("window_size 2 2"), 1, 1, "'window_size' is not supported by this version of Glint"},
    {"fov", and_also("fov 60"), 1, 1, "'fov' is not supported by this version of Glint"},
    {"nshadowrays", and_also("nshadowrays 4"), 1, 1, "'nshadowrays' is not supported by this version of Glint"},
    {"supersample", and_also("dialect mobile2013\nsupersample on"), 2, 1,
     "'supersample' is not supported by this version of Glint"},
    {"of_another_dialect", and_also("dialect mobile2013\nlightpoint 0 0 0 1 1 1 1"), 2, 1,
     "'lightpoint' is a directive of cg-path-tracer, and this file is read as mobile2013 ('dialect' on line 1)"},
    // Counts.
    {"too_few", with_eye("eye 0 0"), 1, 1, "'eye' takes 3 arguments, found 2", "expected: eye x y z"},
    {"none", with_eye("eye"), 1, 1, "'eye' takes 3 arguments, found 0", "expected: eye x y z"},
    {"too_many", with_eye("eye 0 0 5 6"), 1, 11, "'eye' takes 3 arguments, found 4", "expected: eye x y z"},
    {"far_too_many", with_eye("eye" + std::string(400, ' ') + "0 0 5 6 7 8 9"), 1, 410,
     "'eye' takes 3 arguments, found 7", "expected: eye x y z"},
    {"one_argument", and_also("ambient"), 1, 1, "'ambient' takes 1 argument, found 0", "expected: ambient Ia"},
    {"light_without_intensity", with_light("light lamp.obj 1 1 1"), 1, 1, "'light' takes 5 arguments, found 4",
     "expected: light file.obj r g b I"},
    {"object_with_three_numbers", with_object("object wall.obj 1 1 1"), 1, 1, "'object' takes 10 arguments, found 4",
     object_usage},
    {"blank_in_a_file_name", with_object("object my wall.obj 1 1 1 0 1 0 0 0 0"), 1, 36,
     "'object' takes 10 arguments, found 11", object_usage + "; file names cannot contain blanks"},
    {"dialect_without_a_name", and_also("dialect"), 1, 1, "'dialect' takes 1 argument, found 0",
     "expected: dialect name"},
    // Twice.
    {"eye_twice", and_also("EYE 0 0 6"), 2, 1, "'eye' was given already, on line 1"},
    {"synonyms_twice", and_also("reflections 2"), 5, 1, "'max_depth' was given already, on line 1"},
    {"dialect_twice", and_also("dialect mobile2013\ndialect mobile2013"), 2, 1,
     "'dialect' was given already, on line 1"},
    // Numbers.
    {"nan", with_eye("eye nan 0 5"), 1, 5, "x: 'nan' is not a finite number"},
    {"overflow", with_eye("eye 0 1e39 5"), 1, 7, "y: '1e39' is too large", "the largest number is 3.4e38"},
    {"far_out", with_eye("eye 0 0 2e12"), 1, 9, "z is '2e12', expected a number from -1e+12 to 1e+12"},
    {"comma", and_also("ambient 0,5"), 1, 9, "Ia: '0,5' is not a number", "write the decimal point as '.': 0.5"},
    {"junk", and_also("ambient 1.0x"), 1, 9, "Ia: '1.0x' is not a number: 'x' follows '1.0'"},
    {"glued", with_eye("eye 0 0 5-1"), 1, 9, "z: '5-1' is not a number: it looks like two",
     "put a blank between: 5 -1"},
    // Ranges.
    {"negative_background", and_also("background 0 -0.1 0"), 1, 14, "g is '-0.1', expected a number from 0 to 1e+06"},
    {"negative_ambient", and_also("ambient -1"), 1, 9, "Ia is '-1', expected a number from 0 to 1e+06"},
    {"negative_light", with_light("light lamp.obj 1 1 -1 1"), 1, 20, "b is '-1', expected a number from 0 to 1e+06"},
    {"bright_light", with_light("light lamp.obj 1 1 1 1e7"), 1, 22, "I is '1e7', expected a number from 0 to 1e+06"},
    {"colour", with_object("object wall.obj 1 2 1 0 1 0 0 0 0"), 1, 19, "g is '2'" + from_0_to_1},
    {"negative_colour", with_object("object wall.obj -1 1 1 0 1 0 0 0 0"), 1, 17, "r is '-1'" + from_0_to_1},
    {"ka", with_object("object wall.obj 1 1 1 1.5 1 0 0 0 0"), 1, 23, "ka is '1.5'" + from_0_to_1},
    {"kd", with_object("object wall.obj 1 1 1 0 -1 0 0 0 0"), 1, 25, "kd is '-1'" + from_0_to_1},
    {"ks", with_object("object wall.obj 1 1 1 0 1 7 0 0 0"), 1, 27, "ks is '7'" + from_0_to_1},
    {"ke", with_object("object wall.obj 1 1 1 0 1 0 -1 0 0"), 1, 29, "ke is '-1', expected a number from 0 to 1e+06"},
    {"kr", with_object("object wall.obj 1 1 1 0 1 0 0 1.01 0"), 1, 31, "kr is '1.01'" + from_0_to_1},
    {"kt", with_object("object wall.obj 1 1 1 0 1 0 0 0 1.01"), 1, 33, "kt is '1.01'" + from_0_to_1},
    {"kr_and_kt", with_object("object wall.obj 1 1 1 0 1 0 0 0.6 0.5"), 1, 31, "kr + kt is more than 1 ('0.6' + '0.5')",
     "kr and kt are shares of the surface's colour"},
    // The picture.
    {"size_zero", and_also("size 0 0"), 1, 6, "the picture has 0 x 0 pixels, expected at least 1 x 1"},
    {"height_zero", and_also("size 7 0"), 1, 8, "the picture has 7 x 0 pixels, expected at least 1 x 1"},
    {"size_negative", and_also("size -4 4"), 1, 6, "w: '-4' is not a whole number from 0 up"},
    {"size_fraction", and_also("size 4 4.5"), 1, 8, "h: '4.5' is not a whole number from 0 up"},
    {"size_word", and_also("size wide 4"), 1, 6, "w: 'wide' is not a number"},
    {"size_huge", and_also("size 200000 200000"), 1, 6,
     "the picture has '200000' x '200000' pixels, the limit is 67108864 in all", "--max-pixels raises the limit",
     ErrorCode::limit_exceeded},
    {"size_beyond_64_bits", and_also("size 99999999999999999999 1"), 1, 6,
     "the picture has '99999999999999999999' x '1' pixels, the limit is 67108864 in all",
     "--max-pixels raises the limit", ErrorCode::limit_exceeded},
    {"depth_huge", with_depth("max_depth 1000000000"), 1, 11, "the depth is '1000000000', the limit is 1000", "",
     ErrorCode::limit_exceeded},
    {"depth_negative", with_depth("max_depth -1"), 1, 11, "n: '-1' is not a whole number from 0 up"},
    {"depth_fraction", with_depth("max_depth 1.0"), 1, 11, "n: '1.0' is not a whole number from 0 up"},
    // The camera.
    {"ortho_without_width", and_also("ortho 1 -1 1 1"), 1, 12, "the window has no width: x0 and x1 are both '1'"},
    {"ortho_without_height", and_also("ortho -1 0.5 1 0.5"), 1, 16,
     "the window has no height: y0 and y1 are both '0.5'"},
    {"ortho_too_wide", and_also("ortho -1e12 -1 1e12 1"), 1, 1,
     "the camera's window is not finite or reaches beyond 1e12"},
    {"eye_in_the_window", with_eye("eye 1 1 0"), 1, 9, "the eye lies in the image plane z = 0",
     "rays start at the eye and go through that plane"},
    // What is not there.
    {"no_eye", std::string(light) + object + depth, 0, 0, "there is no 'eye'", "expected: eye x y z"},
    {"no_light", std::string(eye) + object + depth, 0, 0, "there is no 'light'", "expected: light file.obj r g b I"},
    {"no_object", std::string(eye) + light + depth, 0, 0, "there is no 'object'", object_usage},
};

INSTANTIATE_TEST_SUITE_P(Of, BadScenes, ::testing::ValuesIn(bad_scenes),
                         [](const auto &bad) { return std::string(bad.param.name); });

TEST_F(SceneFiles, show_all_their_problems_in_one_run) {
    write("broken.obj", "v 0 0 0\nf 1 2 3\n");
    write("empty.obj", "");
    const std::string file = in_folder("bad.sdl").string(), obj = in_folder("broken.obj").string();
    const std::string empty = in_folder("empty.obj").string();
    EXPECT_EQ(
        error_of("eye 0 0 nan\nsise 1 1\nobject broken.obj 1 1 1 0 2 0 0 0 0\nobject empty.obj 1 1 1 0 1 0 0 0 0\n"
                 "object broken.obj 1 1 1 0 1 0 0 0 0\nmax_depth 1\n")
            .text(),
        file + ":1:9: error: z: 'nan' is not a finite number\n    eye 0 0 nan\n            ^\n" +             //
            file + ":2:1: error: unknown directive 'sise'\n    sise 1 1\n    ^\n    did you mean 'size'?\n" + //
            file +
            ":3:27: error: kd is '2', expected a number from 0 to 1\n"
            "    object broken.obj 1 1 1 0 2 0 0 0 0\n                              ^\n" + //
            obj +
            ":2:5: error: vertex 2 does not exist: the file has 1 vertex\n    f 1 2 3\n        ^\n" +         //
            obj + ":2:7: error: vertex 3 does not exist: the file has 1 vertex\n    f 1 2 3\n          ^\n" + //
            empty + ": error: the file has no face ('f'), so there is nothing to see\n    named in " + file +
            ":4:8\n" + //
            file + ": error: there is no 'light'\n    expected: light file.obj r g b I");
}

TEST_F(SceneFiles, that_are_empty_lack_everything) {
    for (const char *text : {"", "# nothing\n", "\r\n\r\n"}) {
        const Error error = error_of(text);
        ASSERT_EQ(error.diagnostics.size(), 3u) << error.text();
        EXPECT_EQ(error.diagnostics[0].message, "there is no 'eye'");
    }
}

TEST_F(SceneFiles, of_another_dialect_are_refused_with_one_error) {
    const Error error = error_of("eye 0 0 nan\nsphere\nmaxdepth 5\nlightpoint 0 0 0 1 1 1 1\n");
    ASSERT_EQ(error.diagnostics.size(), 1u);
    EXPECT_EQ(error.text(),
              in_folder("bad.sdl").string() +
                  ":3:1: error: this version of Glint reads the dialect mobile2013, and the file is cg-path-tracer "
                  "('maxdepth' on line 3)\n    maxdepth 5\n    ^");
}

TEST_F(SceneFiles, that_are_no_text_are_told_so_once) {
    const Error binary = error_of(std::string("eye\0\0\0nonsense\n", 15));
    EXPECT_EQ(binary.text(), in_folder("bad.sdl").string() + ":1:4: error: this is not a text file: it has a NUL byte");
    const Error wide = error_of(std::string("\xff\xfe"
                                            "e\0y\0e\0",
                                            8));
    EXPECT_EQ(wide.diagnostics.at(0).hint, "it looks like UTF-16: save it as UTF-8");
}

TEST_F(SceneFiles, beyond_the_limit_of_triangles_name_the_mesh_that_was_too_much) {
    ReadOptions options;
    options.limits.max_triangles = 2;
    const Error error = error_of(std::string(eye) + light + object + object + object + depth, options);
    ASSERT_EQ(error.diagnostics.size(), 1u);
    EXPECT_EQ(error.code, ErrorCode::limit_exceeded);
    EXPECT_EQ(error.diagnostics[0].line, 4u);
    EXPECT_EQ(error.diagnostics[0].column, 8u);
    EXPECT_EQ(error.diagnostics[0].message, "with this mesh the scene has 3 triangles, the limit is 2");
}

} // namespace
} // namespace glint::test
