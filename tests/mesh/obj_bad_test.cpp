// Faults of OBJ files that no file of tests/sdl/bad/obj can show: several at once, and what must be made when it is
// needed.
#include <string>

#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/written_files.hpp"

namespace glint::test {
namespace {

constexpr const char *three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

const std::string corner_hint = "expected whole numbers as in 1, 1/2, 1//3 or 1/2/3";
const std::string v_takes =
    "'v' takes 3 coordinates, and perhaps a weight and a colour (4, 6 or 7 numbers in all), found ";

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
