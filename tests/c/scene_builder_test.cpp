// Scenes made in C are those that C++ makes.
#include <cstring>

#include <glint/renderer.hpp>

#include "c/c_handles.hpp"
#include "support/meshes.hpp"

namespace glint::test {
namespace {

/// A floor with a texture, a ball, a cube that can move, a lamp and a spot.
Made<glint_scene_builder> a_builder() {
    auto made = make<glint_scene_builder>(glint_scene_builder_create);
    glint_scene_builder *const builder = made.get();
    const float corners[] = {-1, -0.8f, -4, 1, -0.8f, -4, 1, -0.8f, -2, -1, -0.8f, -2};
    const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
    const float uv[] = {0, 0, 1, 0, 1, 1, 0, 1};
    glint_mesh mesh = with_defaults(glint_mesh_init);
    mesh.positions = corners;
    mesh.position_count = 4;
    mesh.triangles = faces;
    mesh.triangle_count = 2;
    mesh.texcoords = uv;
    mesh.texcoord_count = 4;
    uint32_t floor = 99, cube = 99, checks = 99;
    EXPECT_EQ(glint_scene_builder_add_mesh(builder, &mesh, &floor), GLINT_OK);
    EXPECT_EQ(floor, 0u);
    const Mesh solid = test::cube();
    glint_mesh other = with_defaults(glint_mesh_init);
    other.positions = &solid.positions[0].x;
    other.position_count = solid.positions.size();
    other.triangles = &solid.triangles[0].a;
    other.triangle_count = solid.triangles.size();
    EXPECT_EQ(glint_scene_builder_add_mesh(builder, &other, &cube), GLINT_OK);
    EXPECT_EQ(cube, 1u);
    const float texels[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    EXPECT_EQ(glint_scene_builder_add_texture(builder, 2, 2, texels, &checks), GLINT_OK);
    EXPECT_EQ(checks, 0u);

    glint_material material = with_defaults(glint_material_init);
    material.ambient = 0.2f;
    material.texture = checks;
    glint_object object = with_defaults(glint_object_init);
    object.name = "floor";
    object.mesh = floor;
    object.material = &material;
    EXPECT_EQ(glint_scene_builder_add_object(builder, &object), GLINT_OK);

    glint_quadric ball;
    const float centre[3] = {0.4f, -0.5f, -3.0f};
    EXPECT_EQ(glint_quadric_sphere(centre, 0.3f, &ball), GLINT_OK);
    object = with_defaults(glint_object_init);
    object.quadric = &ball;
    EXPECT_EQ(glint_scene_builder_add_object(builder, &object), GLINT_OK);

    glint_pose pose;
    const float axis[3] = {0, 1, 0}, by[3] = {-0.6f, 0.2f, -5.0f};
    EXPECT_EQ(glint_pose_turned(axis, 0.5, nullptr, by, &pose), GLINT_OK);
    object = with_defaults(glint_object_init);
    object.mesh = cube;
    object.pose = &pose;
    EXPECT_EQ(glint_scene_builder_add_object(builder, &object), GLINT_OK);

    glint_light light = with_defaults(glint_light_init);
    const float position[3] = {0, 2, 0};
    light.kind = GLINT_LIGHT_SPOT;
    light.position = position;
    light.inner_angle = 0.5f;
    light.outer_angle = 1.0f;
    light.intensity = 0.5f;
    EXPECT_EQ(glint_scene_builder_add_light(builder, &light), GLINT_OK);
    light = with_defaults(glint_light_init);
    light.kind = GLINT_LIGHT_DIRECTIONAL;
    EXPECT_EQ(glint_scene_builder_add_light(builder, &light), GLINT_OK);

    glint_scene_settings settings = with_defaults(glint_scene_settings_init);
    settings.background[2] = 0.5f;
    settings.ambient = 1.0f;
    EXPECT_EQ(glint_scene_builder_set_settings(builder, &settings), GLINT_OK);
    glint_camera camera;
    const float eye[3] = {0, 0, 3}, target[3] = {0, 0, -3}, up[3] = {0, 1, 0};
    EXPECT_EQ(glint_camera_look_at(eye, target, up, 0.7f, 0.7f, &camera), GLINT_OK);
    EXPECT_EQ(glint_scene_builder_set_camera(builder, &camera), GLINT_OK);
    return made;
}

/// The same in C++.
std::shared_ptr<const Scene> the_same() {
    auto floor = std::make_shared<Mesh>();
    floor->positions = {{-1, -0.8f, -4}, {1, -0.8f, -4}, {1, -0.8f, -2}, {-1, -0.8f, -2}};
    floor->triangles = {{0, 1, 2}, {0, 2, 3}};
    floor->texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    floor->texcoord_corners = floor->triangles;
    auto checks = std::make_shared<Texture>();
    checks->width_px = checks->height_px = 2;
    checks->texels = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    SceneBuilder builder;
    Object carpet;
    carpet.name = "floor";
    carpet.mesh = floor;
    carpet.material.ambient = 0.2f;
    carpet.material.texture = checks;
    builder.add_object(carpet);
    const double x = 0.4f, y = -0.5f, z = -3.0f, r = 0.3f;
    Object ball;
    ball.quadric = Quadric{1, 1, 1, 0, 0, 0, -0.4f, 0.5f, 3.0f, static_cast<float>(x * x + y * y + z * z - r * r)};
    builder.add_object(ball);
    Object box;
    box.mesh = std::make_shared<Mesh>(cube());
    box.pose = RigidTransform::turned({0, 1, 0}, 0.5, {}, {-0.6f, 0.2f, -5.0f});
    builder.add_object(box);
    Light spot;
    spot.kind = Light::Kind::spot;
    spot.position = Point(0, 2, 0);
    spot.inner_angle = 0.5f;
    spot.outer_angle = 1.0f;
    spot.intensity = 0.5f;
    builder.add_light(spot);
    Light sun;
    sun.kind = Light::Kind::directional;
    builder.add_light(sun);
    builder.set_background({0, 0, 0.5f}).set_ambient(1.0f);
    builder.set_camera(Camera::look_at({0, 0, 3}, {0, 0, -3}, {0, 1, 0}, 0.7f, 0.7f));
    auto scene = builder.build();
    EXPECT_TRUE(scene.ok());
    return *scene;
}

TEST(CSceneBuilder, makes_the_scene_that_cpp_makes) {
    const auto builder = a_builder();
    const auto scene =
        make<glint_scene>([&](glint_scene **place) { return glint_scene_builder_build(builder.get(), place); });
    ASSERT_EQ(scene.code, GLINT_OK) << scene.message();
    auto info = to_fill<glint_scene_info>();
    ASSERT_EQ(glint_scene_get_info(scene.get(), &info), GLINT_OK);
    EXPECT_EQ(info.objects, 3u);
    EXPECT_EQ(info.lights, 2u);
    EXPECT_EQ(info.quadrics, 1u);
    EXPECT_STREQ(info.dialect, "");

    const auto renderer = renderer_of(scene.get());
    const auto picture = framebuffer_of(64, 64);
    ASSERT_EQ(glint_renderer_render(renderer.get(), picture.get(), nullptr, nullptr), GLINT_OK) << renderer.message();
    auto expected = Framebuffer::create(64, 64);
    Renderer cpp(Accel::build(the_same()));
    ASSERT_TRUE(expected.ok() && cpp.render(*expected).ok());
    EXPECT_EQ(glint_framebuffer_pixel_hash(picture.get()), expected->pixel_hash());
}

TEST(CSceneBuilder, is_empty_after_building) {
    const auto builder = a_builder();
    for (const glint_error expected : {GLINT_OK, GLINT_ERROR_BAD_INPUT}) {
        const auto scene =
            make<glint_scene>([&](glint_scene **place) { return glint_scene_builder_build(builder.get(), place); });
        EXPECT_EQ(scene.code, expected) << scene.message();
    }
    glint_object object = with_defaults(glint_object_init);
    object.mesh = 0;
    EXPECT_EQ(glint_scene_builder_add_object(builder.get(), &object), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(glint_last_error_message(builder.get()), "there is no mesh of this number");
}

TEST(CSceneBuilder, names_every_problem_of_what_it_was_given) {
    const auto builder = make<glint_scene_builder>(glint_scene_builder_create);
    const float corner[] = {0, 0, 0};
    const uint32_t face[] = {0, 0, 5};
    glint_mesh mesh = with_defaults(glint_mesh_init);
    mesh.positions = corner;
    mesh.position_count = 1;
    mesh.triangles = face;
    mesh.triangle_count = 1;
    ASSERT_EQ(glint_scene_builder_add_mesh(builder.get(), &mesh, nullptr), GLINT_OK);
    glint_material material = with_defaults(glint_material_init);
    material.diffuse = 7.0f;
    glint_object object = with_defaults(glint_object_init);
    object.name = "heap";
    object.mesh = 0;
    object.material = &material;
    ASSERT_EQ(glint_scene_builder_add_object(builder.get(), &object), GLINT_OK);
    const auto scene =
        make<glint_scene>([&](glint_scene **place) { return glint_scene_builder_build(builder.get(), place); });
    EXPECT_EQ(scene.code, GLINT_ERROR_BAD_INPUT);
    EXPECT_NE(scene.message().find("heap"), std::string::npos) << scene.message();
    auto second = to_fill<glint_diagnostic>();
    EXPECT_EQ(glint_scene_get_diagnostic(scene.get(), 1, &second), GLINT_OK) << scene.message();
}

TEST(CSceneBuilder, takes_no_array_that_is_not_there) {
    const auto builder = make<glint_scene_builder>(glint_scene_builder_create);
    glint_mesh mesh = with_defaults(glint_mesh_init);
    mesh.triangle_count = 1;
    EXPECT_EQ(glint_scene_builder_add_mesh(builder.get(), &mesh, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    mesh.triangle_count = 0;
    const float corner[] = {0, 0, 0};
    mesh.positions = corner;
    mesh.position_count = SIZE_MAX / 3;
    EXPECT_EQ(glint_scene_builder_add_mesh(builder.get(), &mesh, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_scene_builder_add_texture(builder.get(), UINT32_MAX, UINT32_MAX, corner, nullptr),
              GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_scene_builder_add_texture(builder.get(), 0, 4, corner, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
}

} // namespace
} // namespace glint::test
