// A pixel's ray tree adds up to the pixel, for every scene there is, and says what its rays really did.
#include <glint/ray_tree.hpp>

#include <gtest/gtest.h>

#include "sdl/good_corpus.hpp"
#include "support/ray_tree_checks.hpp"

namespace glint::test {
namespace {

class TreesOfGoodScene : public testing::TestWithParam<std::string> {};

TEST_P(TreesOfGoodScene, add_up_to_the_pixels) {
    const auto file = read_scene(good_file(GetParam()), good_options());
    ASSERT_TRUE(file.ok()) << file.error().text();
    const PictureSettings &wanted = file->scene->picture();
    Renderer renderer(Accel::build(file->scene));
    const auto accel = Accel::build(file->scene);
    const uint32_t width = std::min(wanted.width_px, 96u), height = std::min(wanted.height_px, 64u);
    for (const uint32_t depth : {0u, 1u, wanted.max_depth, wanted.max_depth + 3}) {
        SCOPED_TRACE("depth " + std::to_string(depth));
        RenderOptions options;
        options.max_depth = depth;
        check_pixels(accel, picture_of(renderer, options, width, height), options, 150);
    }
}

TEST_P(TreesOfGoodScene, have_every_ray_that_the_picture_took) {
    const auto file = read_scene(good_file(GetParam()), good_options());
    ASSERT_TRUE(file.ok()) << file.error().text();
    const auto accel = Accel::build(file->scene);
    Renderer renderer(accel, {2, Isa::scalar});
    Result<Framebuffer> picture = Framebuffer::create(17, 13);
    ASSERT_TRUE(picture.ok());
    const auto took = renderer.render(*picture);
    ASSERT_TRUE(took.ok());
    uint64_t primary = 0, shadow = 0, secondary = 0;
    for (uint32_t y = 0; y < 13; ++y) {
        for (uint32_t x = 0; x < 17; ++x) {
            for (const TracedRay &ray : tree_of(*accel, {}, *picture, x, y).rays) {
                ++(ray.kind == RayKind::primary ? primary : ray.kind == RayKind::shadow ? shadow : secondary);
            }
        }
    }
    EXPECT_EQ(primary, took->primary_rays);
    EXPECT_EQ(shadow, took->shadow_rays);
    EXPECT_EQ(secondary, took->secondary_rays);
}

INSTANTIATE_TEST_SUITE_P(, TreesOfGoodScene, testing::ValuesIn(good_scenes()), [](const auto &scene) {
    std::string name = scene.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

/// A square of the given half side in the plane y = `height`.
std::shared_ptr<const Mesh> square(float half, float height) {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{-half, height, -half}, {half, height, -half}, {half, height, half}, {-half, height, half}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// A floor that mirrors 0.25 and lets 0.5 through; below it a red one, above it blue sky and a small lamp with a screen
/// over one side. The eye looks straight down on the middle.
struct Stack {
    Stack() {
        SceneBuilder builder;
        Material clear;
        clear.color = Color(0.8f);
        clear.diffuse = 0.5f;
        clear.reflection = 0.25f;
        clear.transmission = 0.5f;
        builder.add_object({"pane", square(10.0f, 0.0f), clear});
        Material red;
        red.color = {1.0f, 0.0f, 0.0f};
        builder.add_object({"ground", square(10.0f, -2.0f), red});
        Light lamp{"lamp", nullptr, Color(1.0f), 2.0f};
        lamp.kind = Light::Kind::point;
        lamp.position = Point(0.0f, 3.0f, 0.0f);
        builder.add_light(lamp);
        Light sun{"sun", nullptr, Color(1.0f), 1.0f};
        sun.kind = Light::Kind::directional;
        sun.direction = {0.0f, -2.0f, 0.0f};
        builder.add_light(sun);
        builder.set_background({0.0f, 0.0f, 1.0f});
        builder.set_camera(Camera::look_at({0.1f, 5, 0}, {0.1f, 0, 0}, {0, 0, -1}, 0.01f, 0.01f));
        builder.set_picture({1, 1, 1});
        const auto scene = builder.build();
        if (!scene) throw std::runtime_error(scene.error().text());
        accel = Accel::build(*scene);
    }
    std::shared_ptr<const Accel> accel;
};

TEST(RayTree, of_a_stack_of_panes_is_what_one_works_out_by_hand) {
    const Stack stack;
    const auto tree = trace_ray_tree(*stack.accel, {}, 1, 1, 0, 0);
    ASSERT_TRUE(tree.ok()) << tree.error().text();
    const std::vector<TracedRay> &rays = tree->rays;
    ASSERT_EQ(rays.size(), 7u);
    const auto expect = [&](size_t i, RayKind kind, uint32_t parent, const char *target, float weight,
                            float local_weight, Color local) {
        SCOPED_TRACE(i);
        EXPECT_EQ(rays[i].kind, kind);
        EXPECT_EQ(rays[i].parent, parent);
        EXPECT_EQ(rays[i].target_name, target);
        EXPECT_FLOAT_EQ(rays[i].weight, weight);
        EXPECT_FLOAT_EQ(rays[i].local_weight, local_weight);
        expect_near(rays[i].local_color, local, 2e-3f, "local colour");
    };
    // The lamp's light: 2 * 0.5 * 0.8 * N.L, which is nearly 1; the sun's: 1 * 0.5 * 0.8.
    expect(0, RayKind::primary, no_ray, "pane", 1.0f, 0.25f, Color(0.8f + 0.4f));
    expect(1, RayKind::shadow, 0, "lamp", 0.25f, 0.0f, Color(0.8f));
    expect(2, RayKind::shadow, 0, "sun", 0.25f, 0.0f, Color(0.4f));
    expect(3, RayKind::mirror, 0, "", 0.25f, 0.25f, {0.0f, 0.0f, 1.0f});
    // The pane is in the way of all light to the ground: it blocks as any surface does.
    expect(4, RayKind::transmitted, 0, "ground", 0.5f, 0.5f, Color(0.0f));
    expect(5, RayKind::shadow, 4, "pane", 0.5f, 0.0f, Color(0.0f));
    expect(6, RayKind::shadow, 4, "pane", 0.5f, 0.0f, Color(0.0f));
    EXPECT_NEAR(rays[0].distance, 5.0f, 1e-4f);
    EXPECT_NEAR(rays[1].distance, 3.0f, 2e-3f);
    EXPECT_EQ(rays[2].distance, std::numeric_limits<float>::infinity());
    EXPECT_NEAR(rays[4].distance, 2.0f, 1e-4f);
    EXPECT_NEAR(rays[5].distance, 2.0f, 3e-3f);
    EXPECT_NEAR(rays[6].distance, 2.0f, 1e-4f);
    EXPECT_GT(rays[1].direction.y, 0.99f);
    EXPECT_GT(rays[2].direction.y, 0.99f);
    EXPECT_GT(rays[3].direction.y, 0.99f);
    EXPECT_LT(rays[4].direction.y, -0.99f);
    EXPECT_EQ(rays[1].light, 0u);
    EXPECT_EQ(rays[2].light, 1u);
    expect_near(rays[0].contribution, {0.3f, 0.3f, 0.3f + 0.25f}, 2e-3f, "contribution");
    expect_near(rays[2].contribution, Color(0.1f), 1e-3f, "contribution");
    EXPECT_EQ(rays[3].contribution, Color(0.0f, 0.0f, 0.25f));
}

TEST(RayTree, names_the_surface_in_the_way_that_is_nearest_to_the_point) {
    SceneBuilder builder;
    builder.add_object({"ground", square(10.0f, 0.0f), {}});
    builder.add_object({"high", square(1.0f, 3.0f), {}});
    builder.add_object({"low", square(1.0f, 1.0f), {}});
    Light lamp{"lamp", nullptr, Color(1.0f)};
    lamp.kind = Light::Kind::point;
    lamp.position = Point(0.0f, 5.0f, 0.0f);
    Light sun{"sun", nullptr, Color(1.0f)};
    sun.kind = Light::Kind::directional;
    builder.add_light(lamp).add_light(sun);
    // From the side, below the low one.
    builder.set_camera(Camera::look_at({2, 0.5f, 0}, {0, 0, 0}, {0, 1, 0}, 0.01f, 0.01f));
    const auto scene = builder.build();
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    const auto tree = trace_ray_tree(*Accel::build(*scene), {}, 1, 1, 0, 0);
    ASSERT_TRUE(tree.ok()) << tree.error().text();
    ASSERT_EQ(tree->rays.size(), 3u);
    for (size_t i = 1; i < 3; ++i) {
        EXPECT_EQ(tree->rays[i].light, i - 1);
        EXPECT_EQ(tree->rays[i].light_name, i == 1 ? "lamp" : "sun");
        EXPECT_EQ(tree->rays[i].target_name, "low");
        EXPECT_NEAR(tree->rays[i].distance, 1.0f, 1e-3f);
        EXPECT_EQ(tree->rays[i].light_share, 0.0f);
    }
}

TEST(RayTree, of_depth_0_casts_shadow_rays_only) {
    const Stack stack;
    RenderOptions options;
    options.max_depth = 0;
    const auto tree = trace_ray_tree(*stack.accel, options, 1, 1, 0, 0);
    ASSERT_TRUE(tree.ok());
    ASSERT_EQ(tree->rays.size(), 3u);
    EXPECT_EQ(tree->rays[0].local_weight, 1.0f);
}

TEST(RayTree, says_which_light_though_one_has_many_shadow_rays) {
    SceneBuilder builder;
    builder.add_object({"floor", square(10.0f, 0.0f), {}});
    builder.add_light({"soft", square(0.5f, 3.0f), Color(1.0f)});
    Light grid{"grid", square(0.5f, 3.5f), Color(1.0f)};
    grid.grid_width = 2;
    grid.grid_height = 3;
    Light random{"random", square(0.5f, 4.0f), Color(1.0f)};
    random.shadow_rays = 5;
    Light placed{"placed", square(0.5f, 4.0f), Color(1.0f)};
    placed.position = Point(0.0f, 4.0f, 0.0f);
    builder.add_light(grid).add_light(random).add_light(placed);
    builder.set_camera(Camera::look_at({4, 5, 0}, {4, 0, 0}, {0, 0, -1}, 0.01f, 0.01f));
    const auto scene = builder.build();
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    const auto tree = trace_ray_tree(*Accel::build(*scene), {}, 1, 1, 0, 0);
    ASSERT_TRUE(tree.ok());
    uint32_t rays_to[4] = {};
    for (const TracedRay &ray : tree->rays) {
        if (ray.kind == RayKind::shadow) ++rays_to[ray.light];
    }
    EXPECT_EQ(rays_to[0], 1u);
    EXPECT_EQ(rays_to[1], 6u);
    EXPECT_EQ(rays_to[2], 5u);
    EXPECT_EQ(rays_to[3], 1u);
}

TEST(RayTree, has_primary_rays_that_a_query_of_ones_own_confirms) {
    const auto file = read_scene(good_file("glint_everything"), good_options());
    ASSERT_TRUE(file.ok()) << file.error().text();
    const auto accel = Accel::build(file->scene);
    const RayQuery query(accel);
    for (uint32_t i = 0; i < 300; ++i) {
        const auto tree = trace_ray_tree(*accel, {}, 20, 15, i % 20, i / 20);
        ASSERT_TRUE(tree.ok());
        const TracedRay &ray = tree->rays[0];
        const float t_max = std::numeric_limits<float>::max();
        RayBatch rays;
        rays.count = 1;
        rays.org_x = &ray.origin.x, rays.org_y = &ray.origin.y, rays.org_z = &ray.origin.z;
        rays.dir_x = &ray.direction.x, rays.dir_y = &ray.direction.y, rays.dir_z = &ray.direction.z;
        rays.t_max = &t_max;
        float t = 0.0f;
        uint32_t id = 0;
        query.closest_hits(rays, {&t, &id});
        EXPECT_EQ(id == no_triangle, ray.target == RayTarget::background);
        if (id != no_triangle) {
            EXPECT_EQ(t, ray.distance);
        }
    }
}

TEST(RayTree, of_a_pixel_that_is_not_there_is_refused) {
    const Stack stack;
    const auto expect_refused = [&](uint32_t width, uint32_t height, uint32_t x, uint32_t y) {
        const auto tree = trace_ray_tree(*stack.accel, {}, width, height, x, y);
        ASSERT_FALSE(tree.ok());
        EXPECT_EQ(tree.error().code, ErrorCode::bad_input);
        EXPECT_NE(tree.error().text().find(std::to_string(x) + "," + std::to_string(y)), std::string::npos);
    };
    expect_refused(4, 3, 4, 0);
    expect_refused(4, 3, 0, 3);
    expect_refused(4, 3, UINT32_MAX, UINT32_MAX);
    expect_refused(0, 0, 0, 0);
    expect_refused(0, 5, 0, 0);
}

TEST(RayTree, refuses_what_render_refuses) {
    const Stack stack;
    RenderOptions options;
    options.samples_per_pixel = max_samples + 1;
    EXPECT_FALSE(trace_ray_tree(*stack.accel, options, 1, 1, 0, 0).ok());
    options.samples_per_pixel = 0;
    EXPECT_FALSE(trace_ray_tree(*stack.accel, options, 1, 1, 0, 0).ok());
    options = {};
    options.camera = Camera{};
    options.camera->right = Vector(0.0f);
    EXPECT_FALSE(trace_ray_tree(*stack.accel, options, 1, 1, 0, 0).ok());
}

TEST(RayTree, that_grows_out_of_hand_is_refused) {
    // 4096 samples, 4096 shadow rays each.
    SceneBuilder builder;
    builder.add_object({"floor", square(10.0f, 0.0f), {}});
    Light lamp{"lamp", square(0.5f, 3.0f), Color(1.0f)};
    lamp.shadow_rays = max_samples;
    builder.add_light(lamp);
    builder.set_camera(Camera::look_at({4, 5, 0}, {4, 0, 0}, {0, 0, -1}, 0.01f, 0.01f));
    const auto scene = builder.build();
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    RenderOptions options;
    options.samples_per_pixel = 300;
    const auto tree = trace_ray_tree(*Accel::build(*scene), options, 1, 1, 0, 0);
    ASSERT_FALSE(tree.ok());
    EXPECT_EQ(tree.error().code, ErrorCode::limit_exceeded);
}

} // namespace
} // namespace glint::test
