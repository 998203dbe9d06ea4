// What a good OBJ file becomes, to the last bit.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/written_files.hpp"

namespace glint::test {
namespace {

using std::string_view_literals::operator""sv;

class GoodObjs : public WrittenFiles {
protected:
    MeshFile read(std::string_view text) const {
        auto mesh = read_obj(write("good.obj", text));
        if (!mesh.ok()) throw std::runtime_error(mesh.error().text());
        return std::move(mesh).value();
    }
    std::vector<Triangle> triangles_of(std::string_view text) const { return read(text).mesh->triangles; }
};

using Triangles = std::vector<Triangle>;

TEST_F(GoodObjs, keep_vertices_and_the_order_of_faces) {
    const MeshFile file = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.25 -1.5e2 +7\nf 3 1 2\nf 1 2 4\n");
    const std::vector<Point> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25f, -150, 7}};
    EXPECT_EQ(file.mesh->positions, positions);
    EXPECT_EQ(file.mesh->triangles, (Triangles{{2, 0, 1}, {0, 1, 3}}));
    EXPECT_TRUE(file.warnings.empty());
}

TEST_F(GoodObjs, may_end_lines_as_any_system_does) {
    const auto triangles = Triangles{{0, 1, 2}};
    EXPECT_EQ(triangles_of("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"), triangles);
    EXPECT_EQ(triangles_of("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3"), triangles);
    EXPECT_EQ(triangles_of("\xef\xbb\xbfv 0 0 0\n\n \nv 1 0 0\n  v 0 1 0  \n\tf\t1\t2 3\t"), triangles);
}

TEST_F(GoodObjs, may_have_comments_behind_elements) {
    EXPECT_EQ(
        triangles_of("# all\nv 0 0 0#first\nv 1 0 0 # second 9 9 9\nv 0 1 0\nf 1 2 3 # 4 5 nan\n # end \\\nf 1 3 2"),
        (Triangles{{0, 1, 2}, {0, 2, 1}}));
}

TEST_F(GoodObjs, may_continue_a_line) {
    EXPECT_EQ(triangles_of("v 0 0 \\\n0\nv 1 0 0\nv 0 \\\r\n 1 0\nf 1 \\\n2 \\\n\\\n3\nf 2 3 1\\"),
              (Triangles{{0, 1, 2}, {1, 2, 0}}));
}

TEST_F(GoodObjs, may_name_a_vertex_that_comes_later) {
    EXPECT_EQ(triangles_of("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"), (Triangles{{0, 1, 2}}));
    // A polygon too; its reflex corner, which decides how it is cut, is the one that comes last.
    EXPECT_EQ(triangles_of("v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 4 3\nf 1 2 3\nv 1 1 0\n"),
              (Triangles{{0, 1, 3}, {0, 3, 2}, {0, 1, 2}}));
}

TEST_F(GoodObjs, may_count_back_from_the_line) {
    EXPECT_EQ(triangles_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -1 2\n"),
              (Triangles{{0, 1, 2}, {0, 3, 1}}));
}

TEST_F(GoodObjs, may_have_normals_texture_coordinates_weights_and_colours) {
    const MeshFile file = read("mtllib missing.mtl\no room\ng walls\nusemtl red\ns 1\n"
                               "v 0 0 0 1\nv 1 0 0 1 0.5 0\nv 0 1 0 1 1 1 0.5\nvt 0\nvt 0 1\nvt 0 1 0\nvn 0 0 1\n"
                               "f 1/1 2/2 3/3\nf 1//1 2//1 3//-1\nf 1/1/1 2/-2/1 3/3/1\nf 1/ 2// 3//\n");
    EXPECT_EQ(file.mesh->positions.size(), 3u);
    EXPECT_EQ(file.mesh->positions[1], Point(1, 0, 0));
    EXPECT_EQ(file.mesh->triangles, Triangles(4, Triangle{0, 1, 2}));
    EXPECT_TRUE(file.warnings.empty());
}

TEST_F(GoodObjs, may_write_numbers_in_odd_ways) {
    const std::string zeroes(400, '0');
    const MeshFile file = read("v 0e999 1e-999 -0." + zeroes + "1\n" +                //
                               "v 0." + zeroes + "25e400 1" + zeroes + "e-400 1.\n" + //
                               "v 999999999999 -1e12 1E-40\nf 1 2 3\n");
    EXPECT_EQ(file.mesh->positions[0], Point(0, 0, 0));
    EXPECT_EQ(file.mesh->positions[1], Point(0.25f, 1, 1));
    EXPECT_EQ(file.mesh->positions[2], Point(1e12f, -1e12f, 1e-40f));
}

TEST_F(GoodObjs, may_have_names_in_any_encoding) {
    EXPECT_EQ(triangles_of("# Gr\xfc\xdf\x65\ng caf\xe9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").size(), 1u);
}

TEST_F(GoodObjs, lose_triangles_without_area_with_a_warning) {
    const MeshFile file = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 4\nf 1 2 3\nf 1 1 3\n");
    EXPECT_EQ(file.mesh->triangles, (Triangles{{0, 1, 2}}));
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(file.warnings[0].severity, Diagnostic::Severity::warning);
    EXPECT_EQ(file.warnings[0].message, "2 of the mesh's 3 triangles have no area and are left out");
}

TEST_F(GoodObjs, lose_what_has_no_surface_with_a_warning) {
    const MeshFile file = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\np 3\nl 2 3\nf 1 2 3\n");
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(file.warnings[0].line, 4u);
    EXPECT_EQ(file.warnings[0].source_line, "l 1 2");
    EXPECT_EQ(file.warnings[0].message,
              "3 lines of points or lines ('l' first): they have no surface and are left out");
}

TEST_F(GoodObjs, lose_lines_of_unknown_kinds_with_a_warning) {
    const MeshFile file = read("v 0 0 0\nv 1 0 0\nv 0 1 0\n  vp 0.1\nF 1 2 3\nf 1 2 3\n");
    EXPECT_EQ(file.mesh->triangles.size(), 1u);
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(file.warnings[0].line, 4u);
    EXPECT_EQ(file.warnings[0].column, 3u);
    EXPECT_EQ(file.warnings[0].source_line, "  vp 0.1");
    EXPECT_EQ(file.warnings[0].message, "2 lines of a kind that is not read ('vp' first)");
}

} // namespace
} // namespace glint::test
