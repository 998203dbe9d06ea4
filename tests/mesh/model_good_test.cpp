// What a good OBJ file becomes with its normals, texture coordinates and materials' names.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "mesh/model_files.hpp"

namespace glint::test {
namespace {

using Models = ModelFiles;
using Triangles = std::vector<Triangle>;
constexpr Triangle none{no_corner, no_corner, no_corner};

TEST_F(Models, without_anything_else_are_one_white_mesh) {
    const ModelFile model = read(std::string(four_vertices) + "f 1 2 3 4\n");
    ASSERT_EQ(model.parts.size(), 1u);
    const ModelPart &part = model.parts[0];
    EXPECT_EQ(part.material_name, "");
    EXPECT_EQ(part.mesh->positions, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(part.mesh->triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(part.mesh->normals.empty() && part.mesh->normal_corners.empty());
    EXPECT_TRUE(part.mesh->texcoords.empty() && part.mesh->texcoord_corners.empty());
    EXPECT_EQ(part.material.color, Color(1.0f));
    EXPECT_EQ(part.material.ambient, 1.0f);
    EXPECT_EQ(part.material.diffuse, 1.0f);
    EXPECT_EQ(part.material.specular, 0.0f);
    EXPECT_TRUE(model.warnings.empty());
    EXPECT_EQ(model.files, (std::vector<std::filesystem::path>{in_folder("model.obj")}));
}

TEST_F(Models, have_a_part_for_each_material_in_order_of_first_use) {
    write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue sky\nKd 0 0 1\nnewmtl unused\n");
    const ModelFile model = read("mtllib a.mtl\n" + std::string(four_vertices) +
                                 "v 5 5 5\nv 9 9 9\nusemtl blue sky\nf 1 3 4\nusemtl \t red  \nf 2 3 5\n"
                                 "usemtl unused\nusemtl blue sky\nf 1 2 3\n");
    ASSERT_EQ(model.parts.size(), 2u);
    EXPECT_EQ(model.parts[0].material_name, "blue sky");
    EXPECT_EQ(model.parts[0].material.color, Color(0, 0, 1));
    EXPECT_EQ(model.parts[0].mesh->positions, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(model.parts[0].mesh->triangles, (Triangles{{0, 2, 3}, {0, 1, 2}}));
    EXPECT_EQ(model.parts[1].material_name, "red");
    EXPECT_EQ(model.parts[1].material.color, Color(1, 0, 0));
    EXPECT_EQ(model.parts[1].mesh->positions, (std::vector<Point>{{1, 0, 0}, {1, 1, 0}, {5, 5, 5}}));
    EXPECT_EQ(model.parts[1].mesh->triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(model.files, (std::vector<std::filesystem::path>{in_folder("model.obj"), in_folder("a.mtl")}));
}

TEST_F(Models, keep_normals_and_texture_coordinates_of_each_corner) {
    const ModelFile model =
        read(std::string(four_vertices) + "vt 0.5\nvt 0 0.25\nvt 1 1 1\nvt -3 7.5\nvn 9 9 9\nvn 0 0 1\nvn 0 0.5 1e-20\n"
                                          "f 1/2/2 2/3/3 3/4/-2\nf 1/-1 3/1 4/1\nf 1//2 2//2 4//3\nf 2 3 4\n");
    const Mesh &mesh = *model.parts.at(0).mesh;
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(mesh.normals, (std::vector<Vector>{{0, 0, 1}, {0, 0.5f, 1e-20f}}));
    EXPECT_EQ(mesh.normal_corners, (Triangles{{0, 1, 0}, none, {0, 0, 1}, none}));
    EXPECT_EQ(mesh.texcoords, (std::vector<glm::vec2>{{0.5f, 0}, {0, 0.25f}, {1, 1}, {-3, 7.5f}}));
    EXPECT_EQ(mesh.texcoord_corners, (Triangles{{1, 2, 3}, {3, 0, 0}, none, none}));
    EXPECT_TRUE(model.warnings.empty());
}

TEST_F(Models, with_a_corner_that_lacks_something_lack_it_in_the_whole_triangle) {
    const ModelFile model = read(std::string(four_vertices) + "vt 0 0\nvn 0 0 1\n"
                                                              "f 1/1/1 2/1/1 3/1\nf 1/1/1 2//1 3/1/1\n");
    const Mesh &mesh = *model.parts.at(0).mesh;
    EXPECT_EQ(mesh.normal_corners, (Triangles{none, {0, 0, 0}}));
    EXPECT_EQ(mesh.texcoord_corners, (Triangles{{0, 0, 0}, none}));
}

TEST_F(Models, may_leave_nothing_behind_a_slash) {
    const ModelFile model = read(std::string(four_vertices) + "vt 0 0\nvn 0 0 1\nf 1/ 2// 3/1/\nf 1/1/1 2//1 4/1/1\n"
                                                              "f 1/1/ 2/1/ 3/1/#4\n");
    const Mesh &mesh = *model.parts.at(0).mesh;
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 3}, {0, 1, 2}}));
    EXPECT_EQ(mesh.normal_corners, (Triangles{none, {0, 0, 0}, none}));
    EXPECT_EQ(mesh.texcoord_corners, (Triangles{none, none, {0, 0, 0}}));
}

TEST_F(Models, carry_corners_through_the_cutting_of_polygons) {
    // Concave, so that the cut is not the first that comes to mind; and with each corner's own normal.
    const ModelFile model = read("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nvn 1 0 1\nvn 2 0 1\nvn 3 0 1\nvn 4 0 1\n"
                                 "vt 1 0\nvt 2 0\nvt 3 0\nvt 4 0\nf 1/4/1 2/3/2 3/2/3 4/1/4\n");
    const Mesh &mesh = *model.parts.at(0).mesh;
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.normal_corners, mesh.triangles);
    EXPECT_EQ(mesh.texcoord_corners, (Triangles{{3, 2, 1}, {3, 1, 0}}));
}

TEST_F(Models, tell_the_corners_of_a_polygon_apart_where_they_share_a_place) {
    // A square with a square hole: the outline goes in and back along one cut, over the same two vertices.
    const ModelFile model = read("v 0 0 0\nv 6 0 0\nv 6 6 0\nv 0 6 0\nv 2 2 0\nv 2 4 0\nv 4 4 0\nv 4 2 0\n"
                                 "vt 0 0\nvt 1 0\nvt 2 0\nvt 3 0\nvt 4 0\nvt 5 0\nvt 6 0\nvt 7 0\nvt 8 0\nvt 9 0\n"
                                 "f 1/1 2/2 3/3 4/4 1/5 5/6 6/7 7/8 8/9 5/10\n");
    const Mesh &mesh = *model.parts.at(0).mesh;
    ASSERT_EQ(mesh.triangles.size(), mesh.texcoord_corners.size());
    // The corner of a texture coordinate is known by its number.
    const uint32_t vertex_of[] = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
    std::vector<bool> seen(10, false);
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = mesh.triangles[i], c = mesh.texcoord_corners[i];
        EXPECT_EQ(t, (Triangle{vertex_of[c.a], vertex_of[c.b], vertex_of[c.c]}));
        seen[c.a] = seen[c.b] = seen[c.c] = true;
    }
    EXPECT_EQ(seen, std::vector<bool>(10, true));
}

TEST_F(Models, cut_polygons_as_plain_meshes_do) {
    const std::string text =
        "f 1 2 5 3 4\nv 0 0 0\nv 4 0 0.5\nv 4 4 0\nv 0 4 0\nv 1 1 0\nf 1 2 3 4\nf 1 1 2\nf 5 4 3 2\n";
    const auto plain = read_obj(write("plain.obj", text));
    ASSERT_TRUE(plain.ok());
    const ModelFile model = read(text);
    EXPECT_EQ(model.parts.at(0).mesh->positions, plain->mesh->positions);
    EXPECT_EQ(model.parts.at(0).mesh->triangles, plain->mesh->triangles);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0].message, plain->warnings.at(0).message);
}

TEST_F(Models, lose_triangles_without_area_with_their_corners) {
    const ModelFile model = read(std::string(four_vertices) + "vn 0 0 1\nvn 0 1 1\n"
                                                              "f 1//1 1//1 2//1\nf 1//2 2//2 3//2\nf 2//1 3//1 3//1\n");
    const Mesh &mesh = *model.parts.at(0).mesh;
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(mesh.normals, (std::vector<Vector>{{0, 1, 1}}));
    EXPECT_EQ(mesh.normal_corners, (Triangles{{0, 0, 0}}));
    EXPECT_EQ(model.warnings.at(0).message, "2 of the mesh's 3 triangles have no area and are left out");
}

TEST_F(Models, lose_parts_without_area) {
    write("a.mtl", "newmtl red\nnewmtl blue\n");
    const ModelFile model =
        read("mtllib a.mtl\n" + std::string(four_vertices) + "usemtl red\nf 1 1 2\nusemtl blue\nf 1 2 3\n");
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].material_name, "blue");
}

TEST_F(Models, are_flat_where_a_normal_is_zero) {
    const ModelFile model =
        read(std::string(four_vertices) + "vn 0 0 1\nvn 0 -0 0e5\nf 1//1 2//1 3//2\nf 1//1 2//1 4//1\n");
    const Mesh &mesh = *model.parts.at(0).mesh;
    EXPECT_EQ(mesh.normals, (std::vector<Vector>{{0, 0, 1}}));
    EXPECT_EQ(mesh.normal_corners, (Triangles{none, {0, 0, 0}}));
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0].message, "1 of the file's 2 normals is zero; triangles with such corners are flat");
}

TEST_F(Models, are_flat_where_the_caller_wants_it) {
    ReadOptions options;
    options.flat = true;
    const ModelFile model =
        read(std::string(four_vertices) + "vt 0 0\nvn 0 0 1\nvn 0 0 0\nf 1/1/1 2/1/1 3/1/2\n", options);
    const Mesh &mesh = *model.parts.at(0).mesh;
    EXPECT_TRUE(mesh.normals.empty() && mesh.normal_corners.empty());
    EXPECT_EQ(mesh.texcoord_corners, (Triangles{{0, 0, 0}}));
    EXPECT_TRUE(model.warnings.empty());
}

TEST_F(Models, may_write_normals_and_texture_coordinates_in_odd_ways) {
    const std::string zeroes(400, '0');
    const ModelFile model = read(std::string(four_vertices) + "vn 1" + zeroes + "e-400 0e999 1. # up\n" + //
                                 "vt 0." + zeroes + "25e400 \\\n +1#x\nf 1/1/1 2/1/1 3/1/1 # 4/9/9\n");
    const Mesh &mesh = *model.parts.at(0).mesh;
    EXPECT_EQ(mesh.normals, (std::vector<Vector>{{1, 0, 1}}));
    EXPECT_EQ(mesh.texcoords, (std::vector<glm::vec2>{{0.25f, 1}}));
}

TEST_F(Models, may_name_what_comes_later) {
    const ModelFile model = read("f 1/1/1 2/1/1 3/1/1 4/1/1\nvn 0 0 1\nvt 1 2\n" + std::string(four_vertices));
    EXPECT_EQ(model.parts.at(0).mesh->normals, (std::vector<Vector>{{0, 0, 1}}));
    EXPECT_EQ(model.parts.at(0).mesh->triangles.size(), 2u);
}

TEST_F(Models, have_scenes_that_the_builder_takes) {
    write("a.mtl", "newmtl m\nKs 0.25 0.5 0.1\n");
    const ModelFile model = read("mtllib a.mtl\n" + std::string(four_vertices) +
                                 "vt 0 0\nvn 0 0 1\nusemtl m\nf 1/1/1 2/1/1 3/1 4\nf 1/1/1 2/1/1 3/1/1\n");
    SceneBuilder builder;
    for (const ModelPart &part : model.parts) builder.add_object({part.material_name, part.mesh, part.material});
    const auto scene = builder.build();
    EXPECT_TRUE(scene.ok()) << scene.error().text();
}

} // namespace
} // namespace glint::test
