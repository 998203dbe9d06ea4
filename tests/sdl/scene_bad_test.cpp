// Faults of SDL files that no file of tests/sdl/bad can show: several at once, and what must be made when it is needed.
#include <string>

#include <gtest/gtest.h>

#include "sdl/small_scene.hpp"

namespace glint::test {
namespace {

/// A whole good scene of four lines.
constexpr const char *eye = "eye 0 0 5\n", *light = "light lamp.obj 1 1 1 1\n",
                     *object = "object wall.obj 1 1 1 0 1 0 0 0 0\n", *depth = "max_depth 1\n";

class SceneFiles : public SmallScene {};

TEST_F(SceneFiles, show_all_their_problems_in_one_run) {
    write("broken.obj", "v 0 0 0\nf 1 2 3\n");
    write("empty.obj", "");
    const std::string file = in_folder("scene.sdl").string(), obj = in_folder("broken.obj").string();
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

TEST_F(SceneFiles, of_two_dialects_are_refused_with_one_error) {
    const Error error = error_of("eye 0 0 nan\nsphere\nmaxdepth 5\nmax_depth 5\nlightpoint 0 0 0 1 1 1 1\n");
    ASSERT_EQ(error.diagnostics.size(), 1u) << error.text();
    EXPECT_EQ(error.diagnostics[0].line, 4u);
}

TEST_F(SceneFiles, that_link_to_themselves_are_told_so) {
    std::filesystem::create_symlink("b.obj", in_folder("a.obj"));
    std::filesystem::create_symlink("a.obj", in_folder("b.obj"));
    const Error mesh = error_of(std::string(eye) + light + "object a.obj 1 1 1 0 1 0 0 0 0\n" + depth);
    ASSERT_EQ(mesh.diagnostics.size(), 1u) << mesh.text();
    EXPECT_EQ(mesh.code, ErrorCode::not_found);
    EXPECT_EQ(mesh.diagnostics[0].message, "mesh '" + in_folder("a.obj").string() +
                                               "': there is no such file: its symbolic links go round in a circle");
    std::filesystem::create_symlink("loop.sdl", in_folder("loop.sdl"));
    const auto scene = read_scene(in_folder("loop.sdl"));
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().text(), in_folder("loop.sdl").string() +
                                        ": error: there is no such file: its symbolic links go round in a circle");
    std::filesystem::create_directory_symlink(".", in_folder("here"));
    EXPECT_EQ(
        read(std::string(eye) + light + "object here/here/here/wall.obj 1 1 1 0 1 0 0 0 0\n" + depth).mesh_files.size(),
        2u)
        << "a folder that contains itself is one file's name many times over, and no harm";
}

TEST_F(SceneFiles, that_name_a_mesh_in_a_vast_polygon_say_so_at_the_face) {
    std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
    for (int i = 0; i < 100'001; ++i) face += " 1";
    write("corners.obj", face);
    const Error error = error_of(std::string(eye) + light + "object corners.obj 1 1 1 0 1 0 0 0 0\n" + depth);
    ASSERT_EQ(error.diagnostics.size(), 1u);
    EXPECT_EQ(error.code, ErrorCode::limit_exceeded);
    EXPECT_EQ(error.diagnostics[0].file, in_folder("corners.obj").string());
    EXPECT_EQ(error.diagnostics[0].line, 4u);
    EXPECT_EQ(error.diagnostics[0].message, "the face has 100001 corners, the limit is 100000");
}

TEST_F(SceneFiles, beyond_the_limit_of_triangles_name_the_mesh_that_was_too_much) {
    ReadOptions options;
    options.limits.max_triangles = 3;
    const Error error = error_of(std::string(eye) + light + object + object + object + depth, options);
    ASSERT_EQ(error.diagnostics.size(), 1u);
    EXPECT_EQ(error.code, ErrorCode::limit_exceeded);
    EXPECT_EQ(error.diagnostics[0].line, 4u);
    EXPECT_EQ(error.diagnostics[0].column, 8u);
    EXPECT_EQ(error.diagnostics[0].message, "with this mesh the scene has 4 triangles, the limit is 3");
}

TEST_F(SceneFiles, beyond_the_limit_of_triangles_copy_no_more_meshes_to_other_places) {
    std::string vertices;
    for (int i = 0; i < 100'000; ++i) vertices += "v 0 0 0\n";
    write("many.obj", vertices + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n");
    ReadOptions options;
    options.limits.max_triangles = 3;
    std::string text = "dialect glint\n" + std::string(eye) + light;
    for (int i = 1; i <= 50'000; ++i) {
        text += "object many.obj " + std::to_string(i) + " 0 0 1 1 1 0 1 0 0 0 0 1\n"; // 1.2 MB each, 60 GB in all
    }
    const Error error = error_of(text, options);
    ASSERT_EQ(error.diagnostics.size(), 1u);
    EXPECT_EQ(error.diagnostics[0].message, "with this mesh the scene has 4 triangles, the limit is 3");
}

} // namespace
} // namespace glint::test
