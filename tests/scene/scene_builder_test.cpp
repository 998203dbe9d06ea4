// What becomes a scene, and what is refused.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace glint::test {
namespace {

std::shared_ptr<const Mesh> shared(Mesh mesh) {
    return std::make_shared<Mesh>(std::move(mesh));
}

TEST(SceneBuilder, numbers_objects_before_lights) {
    SceneBuilder builder;
    builder.add_light({"lamp", shared(cube()), Color(1.0f), 2.0f});
    builder.add_object({"first", shared(tetrahedron()), {}});
    builder.add_object({"second", shared(cube()), {}});
    const auto scene = builder.build();
    ASSERT_TRUE(scene) << scene.error().text();
    const Scene &s = **scene;
    EXPECT_EQ(s.triangle_count(), 4u + 12u + 12u);
    ASSERT_EQ(s.surface_count(), 3u);
    EXPECT_FALSE(s.surface(1).is_light);
    EXPECT_EQ(s.surface(1).index, 1u);
    EXPECT_TRUE(s.surface(2).is_light);
    EXPECT_EQ(s.surface(2).index, 0u);
    EXPECT_EQ(s.surface_mesh(0)->triangles.size(), 4u);
}

TEST(SceneBuilder, aims_at_the_area_weighted_centroid_of_a_light) {
    // A unit square at x in [0, 1] and a 1 x 3 one beside it at x in [1, 4]: the centroid is that of the whole strip,
    // though most vertices and triangles are on the left.
    Mesh strip{{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}, {4, 0, 5}, {4, 1, 5}, {0.5f, 0.5f, 5}}, {}};
    strip.triangles = {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 0, 6}, {1, 4, 5}, {1, 5, 2}};
    SceneBuilder builder;
    builder.add_object({"floor", shared(cube()), {}});
    builder.add_light({"strip", shared(strip), Color(1.0f), 1.0f});
    const auto scene = builder.build();
    ASSERT_TRUE(scene);
    EXPECT_NEAR((*scene)->light_positions()[0].x, 2.0f, 1e-6f);
    EXPECT_NEAR((*scene)->light_positions()[0].y, 0.5f, 1e-6f);
    EXPECT_EQ((*scene)->light_positions()[0].z, 5.0f);
}

TEST(SceneBuilder, leaves_triangles_without_area_out_and_counts_them) {
    Mesh mesh = cube();
    mesh.triangles.push_back({0, 0, 1});
    mesh.positions.push_back({0.0f, -1.0f, -1.0f}); // on the edge from 0 to 1
    mesh.triangles.push_back({0, 8, 1});
    const auto original = shared(mesh);
    SceneBuilder builder;
    builder.add_object({"a", original, {}}).add_object({"b", original, {}});
    const auto scene = builder.build();
    ASSERT_TRUE(scene);
    EXPECT_EQ((*scene)->triangle_count(), 24u);
    EXPECT_EQ((*scene)->skipped_triangles(), 4u);
    EXPECT_EQ((*scene)->objects()[0].mesh, (*scene)->objects()[1].mesh) << "a shared mesh stays shared";
    EXPECT_EQ(original->triangles.size(), 14u) << "the caller's mesh is not touched";
}

TEST(SceneBuilder, is_empty_after_building) {
    SceneBuilder builder;
    builder.add_object({"a", shared(cube()), {}});
    ASSERT_TRUE(builder.build());
    EXPECT_FALSE(builder.build());
}

struct BadScene {
    std::string name;
    std::function<void(SceneBuilder &)> spoil;
    std::string message;
    ErrorCode code = ErrorCode::bad_input;
};

std::ostream &operator<<(std::ostream &out, const BadScene &scene) {
    return out << scene.name;
}

class EveryBadScene : public testing::TestWithParam<BadScene> {};

TEST_P(EveryBadScene, is_refused_with_its_message) {
    SceneBuilder builder;
    builder.add_object({"good", shared(cube()), {}});
    GetParam().spoil(builder);
    const auto scene = builder.build();
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, GetParam().code);
    EXPECT_NE(scene.error().text().find(GetParam().message), std::string::npos) << scene.error().text();
}

void add_material(SceneBuilder &builder, const std::function<void(Material &)> &change) {
    Material material;
    change(material);
    builder.add_object({"bad", shared(cube()), material});
}

void add_mesh(SceneBuilder &builder, const std::function<void(Mesh &)> &change) {
    Mesh mesh = cube();
    change(mesh);
    builder.add_object({"bad", shared(mesh), {}});
}

INSTANTIATE_TEST_SUITE_P(
    scenes, EveryBadScene,
    testing::Values(
        BadScene{"no_object", [](SceneBuilder &b) { b = SceneBuilder(); }, "the scene has no object"},
        BadScene{"no_mesh",
                 [](SceneBuilder &b) {
                     b.add_object({"bad", nullptr, {}});
                 },
                 "object 1 'bad': has no mesh"},
        BadScene{"empty_mesh", [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) { m.triangles.clear(); }); },
                 "its mesh has no triangles"},
        BadScene{"index", [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) { m.triangles[4].b = 8; }); },
                 "triangle 4 uses vertex 8 of 8"},
        BadScene{"nan_vertex", [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) { m.positions[2].y = NAN; }); },
                 "vertex 2 is not a finite place"},
        BadScene{"far_vertex", [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) { m.positions[2].y = 1e13f; }); },
                 "within 1e12 of the origin"},
        BadScene{"no_area", [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) {
                                                      m.triangles = {{0, 0, 1}};
                                                  }); },
                 "none of its mesh's triangles has an area"},
        BadScene{"ka", [](SceneBuilder &b) { add_material(b, [](Material &m) { m.ambient = -0.1f; }); }, "ka is -0.1"},
        BadScene{"kd", [](SceneBuilder &b) { add_material(b, [](Material &m) { m.diffuse = 1.5f; }); }, "kd is 1.5"},
        BadScene{"ks", [](SceneBuilder &b) { add_material(b, [](Material &m) { m.specular = NAN; }); }, "ks is nan"},
        BadScene{"ke", [](SceneBuilder &b) { add_material(b, [](Material &m) { m.specular_exponent = -1.0f; }); },
                 "ke is -1"},
        BadScene{"kr_kt",
                 [](SceneBuilder &b) { add_material(b, [](Material &m) { m.reflection = m.transmission = 0.6f; }); },
                 "kr + kt is 1.2"},
        BadScene{"colour", [](SceneBuilder &b) { add_material(b, [](Material &m) { m.color.g = 2.0f; }); },
                 "colour is 2"},
        BadScene{"light",
                 [](SceneBuilder &b) {
                     b.add_light({"lamp", shared(cube()), Color(1.0f), INFINITY});
                 },
                 "light 0 'lamp': intensity is inf"},
        BadScene{"background",
                 [](SceneBuilder &b) {
                     b.set_background({0, 0, -1});
                 },
                 "background is -1"},
        BadScene{"ambient", [](SceneBuilder &b) { b.set_ambient(NAN); }, "ambient is nan"},
        BadScene{"window",
                 [](SceneBuilder &b) {
                     b.set_camera(Camera::through_window({0, 0, 5}, -1, -1, -1, 1));
                 },
                 "the camera's window has no area"},
        BadScene{"eye",
                 [](SceneBuilder &b) {
                     b.set_camera(Camera::through_window({9, 9, 0}, -1, -1, 1, 1));
                 },
                 "the camera's eye lies in the plane of its window"},
        BadScene{"far_eye",
                 [](SceneBuilder &b) {
                     b.set_camera(Camera::through_window({0, INFINITY, 1}, -1, -1, 1, 1));
                 },
                 "the camera's eye is not a finite place"},
        BadScene{"no_pixels",
                 [](SceneBuilder &b) {
                     b.set_picture({0, 10, 1});
                 },
                 "the picture is 0 x 10 pixels"},
        BadScene{"pixels",
                 [](SceneBuilder &b) {
                     b.set_picture({200000, 200000, 1});
                 },
                 "40000000000 pixels, the limit is 67108864", ErrorCode::limit_exceeded},
        BadScene{"depth",
                 [](SceneBuilder &b) {
                     b.set_picture({10, 10, 1001});
                 },
                 "1001 recursive rays in a row, the limit is 1000", ErrorCode::limit_exceeded}),
    [](const auto &test) { return test.param.name; });

TEST(SceneBuilder, reports_every_problem_at_once) {
    SceneBuilder builder;
    builder.add_object({"a", nullptr, {}}).set_ambient(-1.0f).set_picture({0, 0, 1});
    const auto scene = builder.build();
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().diagnostics.size(), 3u);
}

} // namespace
} // namespace glint::test
