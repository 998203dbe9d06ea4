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

void add_light(SceneBuilder &builder, const std::function<void(Light &)> &change) {
    Light light;
    light.name = "lamp";
    light.mesh = shared(cube());
    change(light);
    builder.add_light(light);
}

/// A light without a surface.
void add_lamp(SceneBuilder &builder, Light::Kind kind, const std::function<void(Light &)> &change) {
    Light light;
    light.name = "lamp";
    light.kind = kind;
    light.position = Point(0, 3, 0);
    change(light);
    builder.add_light(light);
}

void add_texture(SceneBuilder &builder, Texture texture) {
    add_material(builder, [&](Material &m) { m.texture = std::make_shared<Texture>(std::move(texture)); });
}

void set_picture(SceneBuilder &builder, const std::function<void(PictureSettings &)> &change) {
    PictureSettings picture;
    change(picture);
    builder.set_picture(picture);
}

constexpr Quadric ball = {1, 1, 1, 0, 0, 0, 0, 0, 0, -1}, point = {1, 1, 1, 0, 0, 0, 0, 0, 0, 0},
                  plane = {0, 0, 0, 0, 0, 0, 0, 1, 0, 0};
constexpr auto a_point = Light::Kind::point, sun = Light::Kind::directional, spot = Light::Kind::spot;

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

TEST(SceneBuilder, keeps_normals_and_texture_coordinates_beside_the_triangles_that_are_left) {
    Mesh mesh = cube();
    mesh.normals = {{0, 0, 1}, {0, 1, 0}};
    mesh.texcoords = {{0, 0}, {1, 1}};
    mesh.triangles.insert(mesh.triangles.begin(), Triangle{0, 0, 1});
    mesh.normal_corners.assign(13, {0, 0, 0});
    mesh.normal_corners[1] = {1, 1, 1};
    mesh.texcoord_corners.assign(13, {no_corner, no_corner, no_corner});
    mesh.texcoord_corners[12] = {1, 1, 1};
    SceneBuilder builder;
    builder.add_object({"a", shared(mesh), {}});
    const auto scene = builder.build();
    ASSERT_TRUE(scene) << scene.error().text();
    const Mesh &kept = *(*scene)->objects()[0].mesh;
    ASSERT_EQ(kept.triangles.size(), 12u);
    ASSERT_EQ(kept.normal_corners.size(), 12u);
    ASSERT_EQ(kept.texcoord_corners.size(), 12u);
    EXPECT_EQ(kept.normal_corners[0], (Triangle{1, 1, 1}));
    EXPECT_EQ(kept.texcoord_corners[11], (Triangle{1, 1, 1}));
    EXPECT_EQ(kept.texcoord_corners[0].a, no_corner);
}

TEST(SceneBuilder, numbers_quadrics_behind_all_triangles) {
    SceneBuilder builder;
    builder.add_object({"ball", nullptr, {}, ball});
    builder.add_object({"cube", shared(cube()), {}});
    builder.add_object({"plane", nullptr, {}, plane});
    Light glow;
    glow.quadric = Quadric{1, 1, 1, 0, 0, 0, 0, -3, 0, 8};
    builder.add_light(glow);
    const auto scene = builder.build();
    ASSERT_TRUE(scene) << scene.error().text();
    const Scene &s = **scene;
    EXPECT_EQ(s.triangle_count(), 12u);
    EXPECT_EQ(s.quadric_surfaces(), (std::vector<uint32_t>{0, 2, 3}));
    EXPECT_EQ(*s.surface_quadric(0), ball);
    EXPECT_EQ(s.surface_quadric(1), nullptr);
    EXPECT_EQ(s.surface_mesh(2), nullptr);
    EXPECT_EQ(s.light_positions()[0], Point(0, 3, 0)) << "the centre of the ball that glows";
}

TEST(SceneBuilder, lets_an_endless_quadric_glow_where_it_is_told_from_where) {
    Light glow;
    glow.quadric = plane;
    glow.position = Point(0, 1, 0);
    SceneBuilder builder;
    builder.add_object({"cube", shared(cube()), {}}).add_light(glow);
    const auto scene = builder.build();
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ((*scene)->light_positions()[0], Point(0, 1, 0));
}

TEST(SceneBuilder, takes_spots_of_every_angle_up_to_pi) {
    SceneBuilder builder;
    builder.add_object({"cube", shared(cube()), {}});
    add_lamp(builder, spot, [](Light &l) { l.outer_angle = l.inner_angle = 3.14159265f; });
    add_lamp(builder, spot, [](Light &) {});
    EXPECT_TRUE(builder.build());
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

INSTANTIATE_TEST_SUITE_P(
    optics, EveryBadScene,
    testing::Values(
        BadScene{"ior", [](SceneBuilder &b) { add_material(b, [](Material &m) { m.ior = 0.0f; }); },
                 "object 1 'bad': index of refraction is 0.0"},
        BadScene{"ior_nan", [](SceneBuilder &b) { add_material(b, [](Material &m) { m.ior = NAN; }); },
                 "index of refraction is nan"},
        BadScene{"highlight",
                 [](SceneBuilder &b) { add_material(b, [](Material &m) { m.highlight_color.b = -1.0f; }); },
                 "highlight colour is -1"},
        BadScene{"texture_without_texels",
                 [](SceneBuilder &b) {
                     add_texture(b, {0, 4, {}});
                 },
                 "its texture is 0 x 4 pixels and has 0"},
        BadScene{"texture_that_lacks_a_texel",
                 [](SceneBuilder &b) {
                     add_texture(b, {2, 2, std::vector<Color>(3)});
                 },
                 "its texture is 2 x 2 pixels and has 3"},
        BadScene{"texture_too_long",
                 [](SceneBuilder &b) {
                     add_texture(b, {(1u << 20) + 1, 1, std::vector<Color>((1u << 20) + 1)});
                 },
                 "its texture is 1048577 x 1 pixels"},
        BadScene{"texture_too_bright",
                 [](SceneBuilder &b) {
                     add_texture(b, {1, 1, {Color(0, 1.5f, 0)}});
                 },
                 "its texture has a channel outside [0, 1]"},
        BadScene{"object_of_two_shapes",
                 [](SceneBuilder &b) {
                     b.add_object({"bad", shared(cube()), {}, ball});
                 },
                 "object 1 'bad': is both a mesh and a quadric"},
        BadScene{"degenerate_quadric",
                 [](SceneBuilder &b) {
                     b.add_object({"bad", nullptr, {}, point});
                 },
                 "object 1 'bad': the quadric is only a point"},
        BadScene{"light_colour", [](SceneBuilder &b) { add_light(b, [](Light &l) { l.color.r = -1; }); },
                 "light 0 'lamp': colour is -1"},
        BadScene{"light_without_a_shape", [](SceneBuilder &b) { add_light(b, [](Light &l) { l.mesh = nullptr; }); },
                 "light 0 'lamp': has no mesh"},
        BadScene{"light_of_two_shapes", [](SceneBuilder &b) { add_light(b, [](Light &l) { l.quadric = ball; }); },
                 "light 0 'lamp': is both a mesh and a quadric"},
        BadScene{"degenerate_light",
                 [](SceneBuilder &b) {
                     add_light(b, [](Light &l) {
                         l.mesh = nullptr;
                         l.quadric = point;
                     });
                 },
                 "light 0 'lamp': the quadric is only a point"},
        BadScene{"endless_light",
                 [](SceneBuilder &b) {
                     add_light(b, [](Light &l) {
                         l.mesh = nullptr;
                         l.quadric = plane;
                     });
                 },
                 "light 0 'lamp': a quadric without bounds has no centre that light could come from"},
        BadScene{"aim", [](SceneBuilder &b) { add_light(b, [](Light &l) { l.position = Point(NAN, 0, 0); }); },
                 "light 0 'lamp': its position is not a finite place"},
        BadScene{"no_shadow_ray", [](SceneBuilder &b) { add_light(b, [](Light &l) { l.shadow_rays = 0; }); },
                 "light 0 'lamp': expected 1 to 4096 shadow rays"},
        BadScene{"shadow_rays", [](SceneBuilder &b) { add_light(b, [](Light &l) { l.shadow_rays = 4097; }); },
                 "expected 1 to 4096 shadow rays"},
        BadScene{"half_a_grid", [](SceneBuilder &b) { add_light(b, [](Light &l) { l.grid_width = 4; }); },
                 "expected 1 to 4096 shadow rays"},
        BadScene{"grid", [](SceneBuilder &b) { add_light(b, [](Light &l) { l.grid_width = l.grid_height = 65; }); },
                 "expected 1 to 4096 shadow rays"},
        BadScene{"vast_grid",
                 [](SceneBuilder &b) { add_light(b, [](Light &l) { l.grid_width = l.grid_height = 1u << 31; }); },
                 "expected 1 to 4096 shadow rays"},
        BadScene{"point_nowhere",
                 [](SceneBuilder &b) { add_lamp(b, a_point, [](Light &l) { l.position = std::nullopt; }); },
                 "light 0 'lamp': its position is not a finite place within 1e12 of the origin"},
        BadScene{"far_point",
                 [](SceneBuilder &b) { add_lamp(b, a_point, [](Light &l) { l.position = Point(0, 2e12f, 0); }); },
                 "its position is not a finite place"},
        BadScene{"point_with_a_shape",
                 [](SceneBuilder &b) { add_lamp(b, a_point, [](Light &l) { l.mesh = shared(cube()); }); },
                 "light 0 'lamp': has a shape, but is not a glowing surface"},
        BadScene{"sun_with_a_shape", [](SceneBuilder &b) { add_lamp(b, sun, [](Light &l) { l.quadric = ball; }); },
                 "has a shape, but is not a glowing surface"},
        BadScene{"sun_without_direction",
                 [](SceneBuilder &b) { add_lamp(b, sun, [](Light &l) { l.direction = Vector(0.0f); }); },
                 "light 0 'lamp': its direction is zero or not finite"},
        BadScene{"spot_without_direction",
                 [](SceneBuilder &b) { add_lamp(b, spot, [](Light &l) { l.direction.y = INFINITY; }); },
                 "light 0 'lamp': its direction is zero or not finite"},
        BadScene{"spot_too_wide", [](SceneBuilder &b) { add_lamp(b, spot, [](Light &l) { l.outer_angle = 3.2f; }); },
                 "light 0 'lamp': outer angle is 3.2"},
        BadScene{"spot_inside_out",
                 [](SceneBuilder &b) {
                     add_lamp(b, spot, [](Light &l) {
                         l.inner_angle = 1.0f;
                         l.outer_angle = 0.5f;
                     });
                 },
                 "light 0 'lamp': inner angle is 1.0"},
        BadScene{"no_samples", [](SceneBuilder &b) { set_picture(b, [](auto &p) { p.samples_per_pixel = 0; }); },
                 "the picture has 0 samples a pixel, expected 1 to 4096"},
        BadScene{"samples", [](SceneBuilder &b) { set_picture(b, [](auto &p) { p.samples_per_pixel = 5000; }); },
                 "the picture has 5000 samples a pixel, expected 1 to 4096"},
        BadScene{"tone", [](SceneBuilder &b) { set_picture(b, [](auto &p) { p.tone_scale = -1.0f; }); },
                 "the scale of the tone curve is -1"},
        BadScene{"normal_zero",
                 [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) {
                                           m.normals = {{0, 0, 1}, {0, 0, 0}};
                                       }); },
                 "object 1 'bad': normal 1 is zero or not finite"},
        BadScene{"normal_nan", [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) {
                                                         m.normals = {{0, NAN, 1}};
                                                     }); },
                 "normal 0 is zero or not finite"},
        BadScene{"normals_of_some",
                 [](SceneBuilder &b) {
                     add_mesh(b, [](Mesh &m) {
                         m.normals = {{0, 0, 1}};
                         m.normal_corners = {{0, 0, 0}};
                     });
                 },
                 "object 1 'bad': has normals for 1 of 12 triangles"},
        BadScene{"normal_index",
                 [](SceneBuilder &b) {
                     add_mesh(b, [](Mesh &m) {
                         m.normals = {{0, 0, 1}};
                         m.normal_corners.assign(12, {0, 0, 0});
                         m.normal_corners[7] = {0, 0, 1};
                     });
                 },
                 "object 1 'bad': triangle 7 uses one of its normals that is not there"},
        BadScene{"half_a_normal",
                 [](SceneBuilder &b) {
                     add_mesh(b, [](Mesh &m) {
                         m.normals = {{0, 0, 1}};
                         m.normal_corners.assign(12, {0, no_corner, 0});
                     });
                 },
                 "triangle 0 uses one of its normals that is not there"},
        BadScene{"texcoord_nan", [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) {
                                                           m.texcoords = {{0, NAN}};
                                                       }); },
                 "object 1 'bad': texture coordinate 0 is not finite"},
        BadScene{"texcoord_index",
                 [](SceneBuilder &b) { add_mesh(b, [](Mesh &m) {
                                           m.texcoord_corners.assign(12, {0, 0, 0});
                                       }); },
                 "triangle 0 uses one of its texture coordinates that is not there"}),
    [](const auto &test) { return test.param.name; });

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
