// Every way in which an OBJ file is refused, with its words.
#include <string>

#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/written_files.hpp"

namespace glint::test {
namespace {

constexpr const char *three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// Text that follows three good vertices (so its first line is line 4), and the one problem it has.
struct BadObj {
    const char *name;
    const char *text;
    uint32_t line, column;
    std::string message;
    std::string hint = {};
};

void PrintTo(const BadObj &bad, std::ostream *out) {
    *out << bad.name;
}

class BadObjs : public WrittenFiles, public ::testing::WithParamInterface<BadObj> {};

TEST_P(BadObjs, are_refused_with_a_place_and_words) {
    const BadObj &bad = GetParam();
    const auto file = write("bad.obj", std::string(three_vertices) + bad.text);
    const auto mesh = read_obj(file);
    ASSERT_FALSE(mesh.ok());
    const Error &error = mesh.error();
    ASSERT_EQ(error.diagnostics.size(), 1u) << error.text();
    EXPECT_EQ(error.code, ErrorCode::bad_input);
    const Diagnostic &diagnostic = error.diagnostics[0];
    EXPECT_EQ(diagnostic.severity, Diagnostic::Severity::error);
    EXPECT_EQ(diagnostic.file, file.string());
    EXPECT_EQ(diagnostic.line, bad.line);
    EXPECT_EQ(diagnostic.column, bad.column);
    EXPECT_EQ(diagnostic.message, bad.message);
    EXPECT_EQ(diagnostic.hint, bad.hint);
    EXPECT_EQ(diagnostic.source_line.empty(), bad.line == 0);
}

const std::string corner_hint = "expected whole numbers as in 1, 1/2, 1//3 or 1/2/3";
const std::string v_takes =
    "'v' takes 3 coordinates, and perhaps a weight and a colour (4, 6 or 7 numbers in all), found ";

const BadObj bad_objs[] = {
    {"no_faces", "", 0, 0, "the file has no face ('f'), so there is nothing to see"},
    {"nan", "v 0 nan 0\nf 1 2 3\n", 4, 5, "'nan' is not a finite number"},
    {"inf", "v 0 0 -inf\nf 1 2 3\n", 4, 7, "'-inf' is not a finite number"},
    {"overflow", "v 1e39 0 0\nf 1 2 3\n", 4, 3, "'1e39' is too large", "the largest number is 3.4e38"},
    {"far_out", "v 0 0 1.1e12\nf 1 2 3\n", 4, 7, "'1.1e12' is too far out", "coordinates reach from -1e12 to 1e12"},
    {"comma", "v 0,5 0 0\nf 1 2 3\n", 4, 3, "'0,5' is not a number", "write the decimal point as '.': 0.5"},
    {"junk", "v 0 0 1.0x\nf 1 2 3\n", 4, 7, "'1.0x' is not a number: 'x' follows '1.0'"},
    {"glued", "v -1-1 0 0\nf 1 2 3\n", 4, 3, "'-1-1' is not a number: it looks like two", "put a blank between: -1 -1"},
    {"word", "v a 0 0\nf 1 2 3\n", 4, 3, "'a' is not a number"},
    {"bad_weight", "v 0 0 0 x\nf 1 2 3\n", 4, 9, "'x' is not a number"},
    {"bad_normal", "vn 0 0 x\nf 1 2 3\n", 4, 8, "'x' is not a number"},
    {"normal_overflow", "vn 0 0 1e40\nf 1 2 3\n", 4, 8, "'1e40' is too large", "the largest number is 3.4e38"},
    {"bad_texcoord", "vt 0.5 nan\nf 1 2 3\n", 4, 8, "'nan' is not a finite number"},
    {"two_coordinates", "v 0 0\nf 1 2 3\n", 4, 1, v_takes + "2"},
    {"five_numbers", "v 0 0 0 1 1\nf 1 2 3\n", 4, 1, v_takes + "5"},
    {"eight_numbers", "v 0 0 0 1 1 1 1 1\nf 1 2 3\n", 4, 1, v_takes + "8"},
    {"no_coordinates", "v\nf 1 2 3\n", 4, 1, v_takes + "0"},
    {"short_normal", "vn 0 0\nf 1 2 3\n", 4, 1, "'vn' takes 3 numbers, found 2"},
    {"long_texcoord", "vt 0 0 0 0\nf 1 2 3\n", 4, 1, "'vt' takes 1 to 3 numbers, found 4"},
    {"two_corners", "f 1 2\n", 4, 1, "a face needs at least 3 corners, found 2"},
    {"no_corners", "f\n", 4, 1, "a face needs at least 3 corners, found 0"},
    {"index_zero", "f 1 0 2\n", 4, 5, "vertex 0 does not exist: OBJ counts from 1"},
    {"index_too_large", "f 1 2 4\n", 4, 7, "vertex 4 does not exist: the file has 3 vertices"},
    {"index_huge", "f 1 2 99999999999999999999\n", 4, 7,
     "vertex 99999999999999999999 does not exist: the file has 3 vertices"},
    {"index_wraps_an_int", "f 1 2 4294967297\n", 4, 7, "vertex 4294967297 does not exist: the file has 3 vertices"},
    {"relative_below_the_start", "f -1 -2 -4\n", 4, 9, "vertex -4 does not exist: 3 vertices come before this line"},
    {"relative_to_what_comes_later", "f -1 -2 -4\nv 0 0 1\n", 4, 9,
     "vertex -4 does not exist: 3 vertices come before this line"},
    {"texcoord_missing", "f 1/1 2/1 3/1\nvt 0 0\nf 1/1 2/1 3/2\n", 6, 13,
     "texture coordinate 2 does not exist: the file has 1 texture coordinate"},
    {"normal_missing", "vn 0 0 1\nf 1//1 2//1 3//-2\n", 5, 16,
     "normal -2 does not exist: 1 normal comes before this line"},
    {"normal_zero", "vn 0 0 1\nf 1//0 2//1 3//1\n", 5, 6, "normal 0 does not exist: OBJ counts from 1"},
    {"fraction", "f 1 2 2.5\n", 4, 7, "'2.5' is not a face's corner", corner_hint},
    {"nan_index", "f 1 2 nan\n", 4, 7, "'nan' is not a face's corner", corner_hint},
    {"only_sign", "f 1 2 -\n", 4, 7, "'-' is not a face's corner", corner_hint},
    {"slash_first", "f 1 2 /3\n", 4, 7, "'/3' is not a face's corner", corner_hint},
    {"three_slashes", "vt 0 0\nvn 0 0 1\nf 1 2 3/1/1/1\n", 6, 7, "'3/1/1/1' is not a face's corner", corner_hint},
    {"continued", "f 1 \\\n 2 \\\n  9\n", 6, 3, "vertex 9 does not exist: the file has 3 vertices"},
    {"continued_crlf", "f 1 \\\r\n 2 \\\r\n  9\r\n", 6, 3, "vertex 9 does not exist: the file has 3 vertices"},
    {"after_a_continued_line", "g a \\\n b\nv x 0 0\nf 1 2 3\n", 6, 3, "'x' is not a number"},
    {"no_area", "f 1 1 2\nf 3 3 3\n", 0, 0, "none of the mesh's triangles has an area"},
};

INSTANTIATE_TEST_SUITE_P(Of, BadObjs, ::testing::ValuesIn(bad_objs),
                         [](const auto &bad) { return std::string(bad.param.name); });

class ObjFiles : public WrittenFiles {};

TEST_F(ObjFiles, show_all_their_problems_in_one_run) {
    const auto file = write("bad.obj", "v 0 0 nan\nv 1 0\nf 1,2,3\nf 1 2 3\n");
    const auto mesh = read_obj(file);
    ASSERT_FALSE(mesh.ok());
    const std::string name = file.string();
    EXPECT_EQ(mesh.error().text(),
              name + ":1:7: error: 'nan' is not a finite number\n    v 0 0 nan\n          ^\n" + //
                  name + ":2:1: error: " + v_takes + "2\n    v 1 0\n    ^\n" +                   //
                  name + ":3:3: error: '1,2,3' is not a face's corner\n    f 1,2,3\n      ^\n    " + corner_hint +
                  "\n" + //
                  name + ":3:1: error: a face needs at least 3 corners, found 1\n    f 1,2,3\n    ^\n" + name +
                  ":4:7: error: vertex 3 does not exist: the file has 2 vertices\n    f 1 2 3\n          ^");
}

TEST_F(ObjFiles, with_endless_problems_show_a_hundred_and_count_the_rest) {
    std::string text = three_vertices;
    for (int i = 0; i < 1000; ++i) text += "f 1 2 9999\nv x 0 0\n";
    const auto mesh = read_obj(write("bad.obj", text));
    ASSERT_FALSE(mesh.ok());
    ASSERT_EQ(mesh.error().diagnostics.size(), 101u);
    EXPECT_EQ(mesh.error().diagnostics[100].message, "and 1900 more problems");
}

TEST_F(ObjFiles, that_are_no_text_are_told_so_once) {
    const auto mesh = read_obj(write("bad.obj", std::string(three_vertices) + std::string("f 1\0 2 3\n", 10)));
    ASSERT_FALSE(mesh.ok());
    ASSERT_EQ(mesh.error().diagnostics.size(), 1u);
    EXPECT_EQ(mesh.error().diagnostics[0].line, 4u);
    EXPECT_EQ(mesh.error().diagnostics[0].column, 4u);
    EXPECT_EQ(mesh.error().diagnostics[0].message, "this is not a text file: it has a NUL byte");
}

TEST_F(ObjFiles, that_are_no_text_have_their_lines_counted_whatever_ends_them) {
    const auto mesh = read_obj(write("bad.obj", std::string("v 0 0 0\rv 1 0 0\r\nv 0 1 0\n\rf 1\0 2 3\n", 36)));
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.error().diagnostics[0].line, 5u);
    EXPECT_EQ(mesh.error().diagnostics[0].column, 4u);
}

TEST_F(ObjFiles, that_cannot_be_opened_are_named) {
    const auto expect = [](const std::filesystem::path &path, const std::string &message) {
        const auto mesh = read_obj(path);
        ASSERT_FALSE(mesh.ok());
        EXPECT_EQ(mesh.error().code, ErrorCode::not_found);
        EXPECT_EQ(mesh.error().text(), path.string() + ": error: " + message);
    };
    expect(in_folder("missing.obj"), "there is no such file");
    expect(in_folder(""), "this is a folder, expected a file");
    expect("/dev/zero", "this is a device, expected a file");
    ASSERT_EQ(::mkfifo(in_folder("pipe.obj").c_str(), 0600), 0);
    expect(in_folder("pipe.obj"), "this is a pipe, expected a file");
}

TEST_F(ObjFiles, beyond_a_limit_say_which) {
    ReadOptions options;
    options.limits.max_triangles = 2;
    const auto many = read_obj(write("many.obj", std::string(three_vertices) + "f 1 2 3\nf 1 2 3\nf 1 2 3\n"), options);
    ASSERT_FALSE(many.ok());
    EXPECT_EQ(many.error().code, ErrorCode::limit_exceeded);
    EXPECT_EQ(many.error().diagnostics[0].message, "the mesh has 3 triangles, the limit is 2");

    options.max_file_bytes = 4;
    const auto large = read_obj(write("large.obj", three_vertices), options);
    ASSERT_FALSE(large.ok());
    EXPECT_EQ(large.error().code, ErrorCode::limit_exceeded);
    EXPECT_EQ(large.error().diagnostics[0].message, "the file has 24 bytes, the limit is 4");

    std::string face = "f";
    for (int i = 0; i < 100'001; ++i) face += " 1";
    const auto corners = read_obj(write("corners.obj", three_vertices + face + "\n"));
    ASSERT_FALSE(corners.ok());
    EXPECT_EQ(corners.error().code, ErrorCode::limit_exceeded);
    EXPECT_EQ(corners.error().diagnostics[0].message, "the face has 100001 corners, the limit is 100000");
}

} // namespace
} // namespace glint::test
