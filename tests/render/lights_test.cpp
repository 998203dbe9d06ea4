// Lights of every kind against values worked out by hand, on every instruction set. A wall at z = -10 faces a camera
// that looks along -z; the picture is one pixel, whose ray is the z axis.
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"
#include "support/picture.hpp"

namespace glint::test {
namespace {

Material matte() {
    Material material;
    material.color = {1.0f, 0.5f, 0.25f};
    return material;
}

/// What each instruction set sees; they must agree to the bit.
Color seen(const SceneBuilder &scene_so_far) {
    SceneBuilder builder = scene_so_far;
    builder.add_object({"wall", square({0, 0, -10}, 4), matte()});
    builder.set_camera(Camera::through_window({0, 0, 5}, -1, -1, 1, 1));
    const auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    const auto accel = Accel::build(*scene);
    const Color first = pixel(render(accel, 1, 1, 0, {.threads = 1, .isa = Isa::scalar}), 0, 0);
    for (const Isa isa : available_isas()) {
        EXPECT_EQ(pixel(render(accel, 1, 1, 0, {.threads = 1, .isa = isa}), 0, 0), first) << isa_name(isa);
    }
    return first;
}

void expect_color(const Color &actual, const Color &expected) {
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(actual[channel], expected[channel], 2e-6f);
}

Light point_light(Point position) {
    Light light;
    light.kind = Light::Kind::point;
    light.position = position;
    return light;
}

Light spot_light(float inner_degrees, float outer_degrees) {
    Light light = point_light({3, 0, -6}); // from the wall's middle in the direction (0.6, 0, 0.8)
    light.kind = Light::Kind::spot;
    light.direction = {0, 0, -2};
    light.inner_angle = inner_degrees * 0.01745329f;
    light.outer_angle = outer_degrees * 0.01745329f;
    return light;
}

TEST(PointLights, shine_without_fading) {
    SceneBuilder near, far;
    near.add_light(point_light({3, 0, -6}));
    far.add_light(point_light({300, 0, 390}));
    expect_color(seen(near), {0.8f, 0.4f, 0.2f});
    expect_color(seen(far), {0.8f, 0.4f, 0.2f});
}

TEST(PointLights, fade_with_the_square_of_the_distance_if_told_to) {
    SceneBuilder builder;
    Light light = point_light({3, 0, -6});
    light.has_falloff = true;
    light.intensity = 50.0f; // at a distance of 5
    builder.add_light(light);
    expect_color(seen(builder), {1.6f, 0.8f, 0.4f});
}

TEST(DirectionalLights, come_from_infinitely_far_away) {
    Light light;
    light.kind = Light::Kind::directional;
    light.direction = {-3, 0, -4}; // any length
    SceneBuilder builder;
    builder.add_light(light);
    expect_color(seen(builder), {0.8f, 0.4f, 0.2f});
    builder.add_object({"far away in between", square({3000, 0, 3990}, 100), matte()});
    expect_color(seen(builder), {0, 0, 0});
    SceneBuilder behind;
    light.direction = {-3, 0, 4};
    behind.add_light(light);
    expect_color(seen(behind), {0, 0, 0});
}

TEST(SpotLights, shine_into_a_cone_with_a_fringe) {
    // The wall's middle is acos(0.8) = 36.87 degrees off the direction.
    const auto with = [](const Light &light) {
        SceneBuilder builder;
        builder.add_light(light);
        return seen(builder);
    };
    expect_color(with(spot_light(40, 50)), {0.8f, 0.4f, 0.2f});
    expect_color(with(spot_light(10, 30)), {0, 0, 0});
    const double inner = std::cos(0.01745329 * 30), outer = std::cos(0.01745329 * 45);
    const double fade = (0.8 - outer) / (inner - outer);
    const auto share = static_cast<float>(fade * fade * (3.0 - 2.0 * fade));
    expect_color(with(spot_light(30, 45)), {0.8f * share, 0.4f * share, 0.2f * share});
    expect_color(with(spot_light(37, 37)), {0.8f, 0.4f, 0.2f});
}

TEST(AimedLights, come_from_where_they_are_told_to) {
    Light lamp{"lamp", square({-3, 0, -6}, 0.5f)};
    lamp.position = Point{3, 0, -6};
    SceneBuilder builder;
    builder.add_light(lamp);
    expect_color(seen(builder), {0.8f, 0.4f, 0.2f});
    builder.add_object({"before the place", square({1.5f, 0, -8}, 0.2f), matte()});
    expect_color(seen(builder), {0, 0, 0});
}

TEST(QuadricLights, shine_from_their_centre_and_do_not_shade_themselves) {
    Light ball;
    ball.quadric = Quadric{1, 1, 1, 0, 0, 0, -3, 0, 6, 9 + 36 - 1};
    SceneBuilder builder;
    builder.add_light(ball);
    expect_color(seen(builder), {0.8f, 0.4f, 0.2f});
}

TEST(QuadricObjects, throw_shadows) {
    Object ball{"ball", nullptr, matte()};
    ball.quadric = Quadric{1, 1, 1, 0, 0, 0, -1.5f, 0, 8, 2.25f + 64 - 0.04f};
    SceneBuilder builder;
    builder.add_light(point_light({3, 0, -6})).add_object(ball);
    expect_color(seen(builder), {0, 0, 0});
}

TEST(ShadowsThroughGlass, are_weaker_by_kt_of_each_surface) {
    for (const bool through : {false, true}) {
        Object ball{"ball", nullptr, matte()};
        ball.quadric = Quadric{1, 1, 1, 0, 0, 0, -1.5f, 0, 8, 2.25f + 64 - 0.04f};
        ball.material.transmission = 0.5f;
        ball.material.ior = 1.5f;
        Object pane{"pane", square({2.25f, 0, -7}, 0.2f), matte()};
        pane.material.transmission = 0.8f;
        SceneBuilder builder;
        builder.add_light(point_light({3, 0, -6})).add_object(ball).add_object(pane).set_optics({false, through});
        const float share = through ? 0.5f * 0.5f * 0.8f : 0.0f; // the ball is met twice
        expect_color(seen(builder), {0.8f * share, 0.4f * share, 0.2f * share});
        builder.add_object({"wood", square({2.7f, 0, -6.4f}, 0.1f), matte()});
        expect_color(seen(builder), {0, 0, 0});
    }
}

TEST(SoftShadows, get_nearer_to_the_truth_with_more_rays) {
    // A wall seen from the side of the lamp, its middle lit by a lamp of which an edge hides the half with x < 0.
    const auto share = [](uint32_t rays, uint32_t width, uint32_t height) {
        Light lamp{"lamp", square({0, 6, -6}, 1)};
        lamp.shadow_rays = rays;
        lamp.grid_width = width;
        lamp.grid_height = height;
        SceneBuilder builder;
        builder.add_light(lamp);
        const float open = seen(builder).x;
        builder.add_object({"edge", square({-1.0f, 3, -8}, 1), matte()});
        return seen(builder).x / open;
    };
    EXPECT_NEAR(share(1000, 0, 0), 0.5f, 0.03f);
    EXPECT_NEAR(share(1, 20, 20), 0.5f, 0.05f);
}

} // namespace
} // namespace glint::test
