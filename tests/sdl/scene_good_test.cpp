// What a good SDL file becomes, to the last bit.
#include <string>

#include <gtest/gtest.h>

#include "sdl/small_scene.hpp"

namespace glint::test {
namespace {

class GoodScenes : public SmallScene {};

constexpr std::string_view shortest = "eye 0 0 5\nlight lamp.obj 1 1 1 1\n"
                                      "object wall.obj 1 1 1 0 1 0 0 0 0\nmax_depth 1\n";

TEST_F(GoodScenes, are_read_to_the_last_bit) {
    const SceneFile file = read("# all of mobile2013\n"
                                "Eye 0.5 -1 5.7\nsize 640 480\northo -2 -1.5 2 1.25\nbackground 0.1 0.2 0.3\n"
                                "AMBIENT 0.9\nmax_depth 3\noutput room.png\n"
                                "light lamp.obj 1.0 0.5 0.25 2.0\n"
                                "object wall.obj 0.5 0 0.125 .3 0.7 1e-1 10 0.75 0.25\r\n"
                                "object wall.obj 1 1 1 1 1 1 0 0 0 # second\n");
    const Scene &scene = *file.scene;
    EXPECT_EQ(scene.camera().eye, Point(0.5f, -1, 5.7f));
    EXPECT_EQ(scene.camera().top_left, Point(-2, 1.25f, 0));
    EXPECT_EQ(scene.camera().right, Vector(4, 0, 0));
    EXPECT_EQ(scene.camera().down, Vector(0, -2.75f, 0));
    EXPECT_EQ(scene.picture().width_px, 640u);
    EXPECT_EQ(scene.picture().height_px, 480u);
    EXPECT_EQ(scene.picture().max_depth, 3u);
    EXPECT_EQ(scene.background(), Color(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.ambient(), 0.9f);

    ASSERT_EQ(scene.lights().size(), 1u);
    EXPECT_EQ(scene.lights()[0].name, "lamp.obj");
    EXPECT_EQ(scene.lights()[0].color, Color(1, 0.5f, 0.25f));
    EXPECT_EQ(scene.lights()[0].intensity, 2.0f);
    EXPECT_EQ(scene.lights()[0].mesh->triangles.size(), 2u);

    ASSERT_EQ(scene.objects().size(), 2u);
    const Material &material = scene.objects()[0].material;
    EXPECT_EQ(scene.objects()[0].name, "wall.obj");
    EXPECT_EQ(material.color, Color(0.5f, 0, 0.125f));
    EXPECT_EQ(material.ambient, 0.3f);
    EXPECT_EQ(material.diffuse, 0.7f);
    EXPECT_EQ(material.specular, 0.1f);
    EXPECT_EQ(material.specular_exponent, 10.0f);
    EXPECT_EQ(material.reflection, 0.75f);
    EXPECT_EQ(material.transmission, 0.25f);
    EXPECT_EQ(scene.objects()[1].material.color, Color(1, 1, 1));

    EXPECT_EQ(file.dialect, "mobile2013");
    EXPECT_EQ(file.dialect_reason, "'max_depth' on line 7");
    EXPECT_EQ(file.output_file, "room.png");
    EXPECT_TRUE(file.warnings.empty());
}

TEST_F(GoodScenes, have_defaults_for_what_they_do_not_say) {
    const SceneFile file = read(shortest);
    EXPECT_EQ(file.scene->camera().top_left, Point(-1, 1, 0));
    EXPECT_EQ(file.scene->camera().right, Vector(2, 0, 0));
    EXPECT_EQ(file.scene->camera().down, Vector(0, -2, 0));
    EXPECT_EQ(file.scene->picture().width_px, 256u);
    EXPECT_EQ(file.scene->picture().height_px, 256u);
    EXPECT_EQ(file.scene->background(), Color(0, 0, 0));
    EXPECT_EQ(file.scene->ambient(), 0.0f);
    EXPECT_EQ(file.output_file, std::nullopt);
    EXPECT_EQ(read("dialect mobile2013\neye 0 0 5\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 1 1 0 1 0 0 0 0\n")
                  .scene->picture()
                  .max_depth,
              1u);
}

TEST_F(GoodScenes, may_begin_with_a_byte_order_mark_and_end_without_a_newline) {
    std::string text = "\xef\xbb\xbf" + std::string(shortest);
    text.pop_back();
    EXPECT_EQ(read(text).scene->objects().size(), 1u);
}

TEST_F(GoodScenes, read_a_mesh_once_however_often_and_however_they_name_it) {
    std::filesystem::create_symlink("wall.obj", in_folder("same.obj"));
    const SceneFile file = read(std::string(shortest) + "object wall.obj 1 1 1 0 1 0 0 0 0\n"
                                                        "object ./wall.obj 1 1 1 0 1 0 0 0 0\n"
                                                        "object same.obj 1 1 1 0 1 0 0 0 0\nlight wall.obj 1 1 1 1\n");
    const auto &objects = file.scene->objects();
    ASSERT_EQ(objects.size(), 4u);
    for (const Object &object : objects) EXPECT_EQ(object.mesh, objects[0].mesh);
    EXPECT_EQ(file.scene->lights()[1].mesh, objects[0].mesh);
    EXPECT_EQ(file.mesh_files, (std::vector<std::filesystem::path>{in_folder("lamp.obj"), in_folder("wall.obj")}));
}

TEST_F(GoodScenes, may_be_read_as_the_dialect_the_caller_names) {
    ReadOptions options;
    options.dialect = "mobile2013";
    const SceneFile file = read("eye 0 0 5\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 1 1 0 1 0 0 0 0\n", options);
    EXPECT_EQ(file.dialect_reason, "the caller asked for it");
}

TEST_F(GoodScenes, pass_on_the_warnings_of_their_meshes) {
    const auto mesh = write("thin.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
    const SceneFile file = read(std::string(shortest) + "object thin.obj 1 1 1 0 1 0 0 0 0\n"
                                                        "object thin.obj 1 1 1 0 1 0 0 0 0\n");
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(file.warnings[0].text(),
              mesh.string() + ": warning: 1 of the mesh's 2 triangles have no area and are left out");
    EXPECT_EQ(file.scene->skipped_triangles(), 0u) << "the reader left them out, so the builder has none to skip";
}

TEST_F(GoodScenes, may_go_up_to_the_limits) {
    ReadOptions options;
    options.limits.max_pixels = 12;
    options.limits.max_depth = 5;
    options.limits.max_triangles = 3;
    const SceneFile file = read("eye 0 0 5\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 1 1 0 1 0 0 0.7 0.3\n"
                                "max_depth 5\nsize 4 3\n",
                                options);
    EXPECT_EQ(file.scene->triangle_count(), 3u);
}

} // namespace
} // namespace glint::test
