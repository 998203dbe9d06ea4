// Shading and the depth rule against values worked out by hand. The camera looks down -z from (0, 0, 5); the picture is
// one pixel, whose ray is the z axis.
#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/picture.hpp"

namespace glint::test {
namespace {

/// Shows exactly its colour when the scene's ambient intensity is 1.
Material plain(Color color, float kr = 0.0f, float kt = 0.0f) {
    return {color, 1.0f, 0.0f, 0.0f, 0.0f, kr, kt};
}

/// The wall of all these tests: at z = -10, across the view.
Object wall(const Material &material) {
    return {"wall", square({0.3f, 0.2f, -10}, 4), material};
}

Color seen(SceneBuilder &builder, uint32_t depth = 0) {
    builder.set_camera(Camera::through_window({0, 0, 5}, -1, -1, 1, 1));
    const auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return pixel(render(*scene, 1, 1, depth), 0, 0);
}

void expect_color(const Color &actual, const Color &expected) {
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(actual[channel], expected[channel], 1e-6f);
}

const Material glossy = {{0.5f, 1.0f, 0.25f}, 0.2f, 0.5f, 0.3f, 2.0f, 0.0f, 0.0f};

/// At (3, 0, -6): seen from the wall's middle its direction is (0.6, 0, 0.8).
Light lamp(Color color = {1.0f, 0.5f, 0.25f}, float intensity = 2.0f) {
    return {"lamp", square({3, 0, -6}, 0.5f), color, intensity};
}

TEST(Shading, adds_ambient_diffuse_and_specular_light) {
    SceneBuilder builder;
    builder.add_object(wall(glossy)).add_light(lamp()).set_ambient(0.5f);
    // ka Ia C = 0.1 C. N.L = 0.8; R.V = 0.8, squared 0.64; ks of that 0.192. kd C N.L = 0.4 C. L = (2, 1, 0.5).
    expect_color(seen(builder),
                 {0.05f + 2.0f * (0.2f + 0.192f), 0.1f + 1.0f * (0.4f + 0.192f), 0.025f + 0.5f * (0.1f + 0.192f)});
}

TEST(Shading, does_not_fall_off_with_distance) {
    SceneBuilder builder;
    Light far = lamp();
    far.mesh = square({3000, 0, 3990}, 0.5f); // the same direction, a thousand times as far
    builder.add_object(wall(glossy)).add_light(far).set_ambient(0.5f);
    expect_color(seen(builder), {0.834f, 0.692f, 0.171f});
}

TEST(Shading, adds_up_lights) {
    SceneBuilder builder;
    builder.add_object(wall(glossy)).set_ambient(0.5f);
    builder.add_light(lamp({1, 0, 0}, 1.0f)).add_light(lamp({0, 1, 0}, 1.0f)).add_light(lamp({1, 1, 0}, 1.0f));
    expect_color(seen(builder), {0.05f + 2.0f * 0.392f, 0.1f + 2.0f * 0.592f, 0.025f});
}

TEST(Shading, ignores_a_light_behind_the_surface) {
    SceneBuilder builder;
    Light behind = lamp();
    behind.mesh = square({3, 0, -14}, 0.5f);
    builder.add_object(wall(glossy)).add_light(behind).set_ambient(0.5f);
    expect_color(seen(builder), {0.05f, 0.1f, 0.025f});
}

TEST(Shading, lights_the_side_that_the_viewer_sees) {
    Object turned_over = wall(glossy);
    Mesh mesh = *turned_over.mesh;
    for (Triangle &t : mesh.triangles) std::swap(t.a, t.b);
    turned_over.mesh = std::make_shared<Mesh>(mesh);
    SceneBuilder builder;
    builder.add_object(turned_over).add_light(lamp()).set_ambient(0.5f);
    expect_color(seen(builder), {0.834f, 0.692f, 0.171f});
}

TEST(Shadows, fall_where_something_stands_before_the_light) {
    SceneBuilder builder;
    builder.add_object(wall(glossy)).add_light(lamp()).set_ambient(0.5f);
    builder.add_object({"blocker", square({1.5f, 0, -8}, 0.2f), plain(Color(1.0f))});
    expect_color(seen(builder), {0.05f, 0.1f, 0.025f});
}

TEST(Shadows, do_not_fall_from_what_stands_beyond_the_light_or_beside_it) {
    SceneBuilder builder;
    builder.add_object(wall(glossy)).add_light(lamp()).set_ambient(0.5f);
    builder.add_object({"beyond", square({4.5f, 0, -4}, 0.2f), plain(Color(1.0f))});
    builder.add_object({"beside", square({1.5f, 1.0f, -8}, 0.2f), plain(Color(1.0f))});
    expect_color(seen(builder), {0.834f, 0.692f, 0.171f});
}

TEST(Shadows, are_not_cast_by_a_light_on_itself_but_by_one_light_on_another) {
    Light box = lamp();
    Mesh closed = moved(cube(), {3, 0, -6}); // its centroid is inside
    box.mesh = std::make_shared<Mesh>(closed);
    SceneBuilder alone;
    alone.add_object(wall(glossy)).add_light(box).set_ambient(0.5f);
    expect_color(seen(alone), {0.834f, 0.692f, 0.171f});

    Light dark = lamp(Color(0.0f));
    dark.mesh = square({1.5f, 0, -8}, 0.2f);
    SceneBuilder shadowed;
    shadowed.add_object(wall(glossy)).add_light(box).add_light(dark).set_ambient(0.5f);
    expect_color(seen(shadowed), {0.05f, 0.1f, 0.025f});
}

TEST(Lights, are_seen_as_their_colour_times_intensity) {
    Light light = lamp({0.5f, 0.25f, 1.0f}, 3.0f);
    light.mesh = square({0, 0, -3}, 1);
    SceneBuilder builder;
    builder.add_object(wall(glossy)).add_light(light).set_ambient(1.0f);
    expect_color(seen(builder, 5), {1.5f, 0.75f, 3.0f});
}

TEST(Background, is_seen_past_everything) {
    SceneBuilder builder;
    builder.add_object({"aside", square({50, 0, -10}, 1), plain(Color(1.0f))}).set_background({0.1f, 0.2f, 0.3f});
    expect_color(seen(builder), {0.1f, 0.2f, 0.3f});
}

const Color front{1.0f, 0.5f, 0.0f}, back{0.0f, 1.0f, 0.25f};

/// Two mirrors facing each other, one before the eye and one behind it.
SceneBuilder mirrors(float front_kr, float back_kr) {
    SceneBuilder builder;
    builder.add_object(wall(plain(front, front_kr))).set_ambient(1.0f);
    builder.add_object({"behind", square({0.1f, 0.2f, 20}, 30), plain(back, back_kr)});
    return builder;
}

TEST(Depth, zero_shows_local_colours_only) {
    SceneBuilder builder = mirrors(0.8f, 0.5f);
    expect_color(seen(builder, 0), front);
}

TEST(Depth, one_mirrors_once_and_keeps_the_local_colour_at_the_limit) {
    SceneBuilder builder = mirrors(0.8f, 0.5f);
    expect_color(seen(builder, 1), 0.2f * front + 0.8f * back);
}

TEST(Depth, two_mirrors_twice) {
    SceneBuilder builder = mirrors(0.8f, 0.5f);
    expect_color(seen(builder, 2), 0.2f * front + 0.8f * (0.5f * back + 0.5f * front));
}

TEST(Depth, ends_where_nothing_reflects) {
    SceneBuilder builder = mirrors(0.8f, 0.0f);
    expect_color(seen(builder, 1000), 0.2f * front + 0.8f * back);
}

TEST(Depth, of_a_thousand_between_perfect_mirrors_ends) {
    SceneBuilder builder = mirrors(1.0f, 1.0f);
    expect_color(seen(builder, 1000), front);
    builder = mirrors(1.0f, 1.0f);
    expect_color(seen(builder, 999), back);
}

TEST(Transmission, goes_straight_on_and_counts_as_depth) {
    const auto scene = [] {
        SceneBuilder builder;
        builder.add_object({"pane", square({0, 0, -5}, 2), plain(front, 0.0f, 0.75f)}).set_ambient(1.0f);
        builder.add_object({"wall", square({0, 0, -10}, 9), plain(back)});
        return builder;
    };
    SceneBuilder none = scene(), one = scene();
    expect_color(seen(none, 0), front);
    expect_color(seen(one, 1), 0.25f * front + 0.75f * back);
}

TEST(Transmission, shares_the_colour_with_reflection) {
    SceneBuilder builder;
    builder.add_object({"pane", square({0, 0, -5}, 2), plain(front, 0.5f, 0.25f)}).set_ambient(1.0f);
    builder.add_object({"wall", square({0, 0, -10}, 9), plain(back)}).set_background({0.5f, 0.5f, 1.0f});
    expect_color(seen(builder, 1), 0.25f * front + 0.5f * Color(0.5f, 0.5f, 1.0f) + 0.25f * back);
}

TEST(Transmission, through_many_half_mirrors_stays_bounded) {
    SceneBuilder builder;
    for (int i = 0; i < 40; ++i) {
        builder.add_object({"pane", square({0, 0, -5.0f - static_cast<float>(i)}, 9), plain(front, 0.5f, 0.5f)});
    }
    builder.set_ambient(1.0f).set_background(front);
    expect_color(seen(builder, 1000), front); // every path ends in the same colour: nothing may be lost on the way
}

TEST(RayCounts, are_exact) {
    SceneBuilder builder = mirrors(0.8f, 0.5f);
    builder.add_light(lamp()).set_camera(Camera::through_window({0, 0, 5}, -1, -1, 1, 1));
    const auto scene = builder.build();
    ASSERT_TRUE(scene);
    auto target = Framebuffer::create(1, 1);
    Renderer renderer(Accel::build(*scene), {1});
    RenderOptions options;
    options.max_depth = 2;
    const auto statistics = renderer.render(*target, options);
    ASSERT_TRUE(statistics);
    EXPECT_EQ(statistics->primary_rays, 1u);
    EXPECT_EQ(statistics->secondary_rays, 2u);
    EXPECT_EQ(statistics->shadow_rays, 3u);
}

} // namespace
} // namespace glint::test
