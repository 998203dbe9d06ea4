// Renders as jobs: the same bits for any number of threads, watched, stopped, side by side.
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "render/tiling.hpp"
#include "support/meshes.hpp"
#include "support/picture.hpp"

namespace glint::test {
namespace {

/// A mirroring torus and a glossy soup under a lamp: every kind of ray.
std::shared_ptr<const Scene> busy_scene() {
    SceneBuilder builder;
    const Material mirror{{0.9f, 0.8f, 0.7f}, 0.2f, 0.5f, 0.3f, 20.0f, 0.5f, 0.0f};
    const Material glass{{0.3f, 0.8f, 0.9f}, 0.2f, 0.6f, 0.2f, 5.5f, 0.2f, 0.5f};
    builder.add_object({"torus", std::make_shared<Mesh>(moved(turned(torus(24, 12)), {0, 0, -1.5f})), mirror});
    builder.add_object({"soup", std::make_shared<Mesh>(moved(soup(40), {0, 0, -3})), glass});
    builder.add_light({"lamp", std::make_shared<Mesh>(moved(tetrahedron(), {4, 6, 3})), Color(1.0f), 0.8f});
    builder.set_ambient(0.3f).set_background({0.1f, 0.1f, 0.2f}).set_picture({100, 75, 4});
    builder.set_camera(Camera::through_window({0, 0, 4}, -1.2f, -0.9f, 1.2f, 0.9f));
    const auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return *scene;
}

TEST(Pixels, do_not_depend_on_the_number_of_threads) {
    const auto scene = busy_scene();
    const Framebuffer one = render(scene, 100, 75, 4, 1);
    for (const unsigned threads : {2u, 3u, 8u}) {
        const Framebuffer many = render(scene, 100, 75, 4, threads);
        EXPECT_EQ(many.pixel_hash(), one.pixel_hash()) << threads << " threads";
        EXPECT_EQ(many.radiance_hash(), one.radiance_hash()) << threads << " threads";
    }
}

TEST(Pixels, are_the_same_with_and_without_a_tree) {
    const auto scene = busy_scene();
    const uint64_t expected = render(scene, 64, 48, 3, 2, AccelKind::brute).radiance_hash();
    EXPECT_EQ(render(scene, 64, 48, 3, 2, AccelKind::kdtree).radiance_hash(), expected);
    EXPECT_EQ(render(scene, 64, 48, 3, 2, AccelKind::bvh).radiance_hash(), expected);
}

TEST(Pixels, do_not_depend_on_keeping_the_radiance) {
    const auto scene = busy_scene();
    auto without = Framebuffer::create(50, 37, false);
    Renderer renderer(Accel::build(scene), {2});
    ASSERT_TRUE(renderer.render(*without));
    EXPECT_EQ(without->pixel_hash(), render(scene, 50, 37, 4).pixel_hash());
}

TEST(Pixels, of_odd_sizes_are_all_written) {
    const auto scene = busy_scene();
    for (const auto &[width, height] : {std::pair{1u, 1u}, {1u, 40u}, {17u, 1u}, {33u, 31u}}) {
        const Framebuffer picture = render(scene, width, height, 1);
        for (uint32_t i = 0; i < width * height; ++i) ASSERT_EQ(picture.rgba8()[i * 4 + 3], 255);
    }
}

TEST(Pixels, are_those_of_the_camera_in_the_options) {
    const auto scene = busy_scene();
    Renderer renderer(Accel::build(scene), {2});
    auto own = Framebuffer::create(40, 30), given = Framebuffer::create(40, 30);
    ASSERT_TRUE(renderer.render(*own));
    RenderOptions options;
    options.camera = scene->camera();
    options.camera->eye.x += 0.5f;
    ASSERT_TRUE(renderer.render(*given, options));
    EXPECT_NE(own->pixel_hash(), given->pixel_hash());
    options.camera->right = {0, 0, 0};
    const auto refused = renderer.render(*given, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::bad_input);
}

TEST(Tiles, cover_every_pixel_once) {
    for (const auto &[width, height] : {std::pair{1u, 1u}, {16u, 16u}, {17u, 33u}, {255u, 3u}}) {
        const Tiling tiling(width, height);
        std::vector<int> covered(size_t{width} * height, 0);
        for (uint32_t i = 0; i < tiling.count(); ++i) {
            const Tile tile = tiling.tile(i);
            for (uint32_t y = tile.y0; y < tile.y1; ++y) {
                for (uint32_t x = tile.x0; x < tile.x1; ++x) ++covered.at(size_t{y} * width + x);
            }
        }
        for (const int times : covered) ASSERT_EQ(times, 1);
    }
}

/// Whole tiles are rendered, the others untouched.
uint32_t finished_tiles(const Framebuffer &picture) {
    const Tiling tiling(picture.width_px(), picture.height_px());
    uint32_t finished = 0;
    for (uint32_t i = 0; i < tiling.count(); ++i) {
        const Tile tile = tiling.tile(i);
        uint32_t written = 0;
        for (uint32_t y = tile.y0; y < tile.y1; ++y) {
            for (uint32_t x = tile.x0; x < tile.x1; ++x) {
                written += picture.rgba8()[(size_t{y} * picture.width_px() + x) * 4 + 3] == 255;
            }
        }
        const uint32_t pixels = (tile.x1 - tile.x0) * (tile.y1 - tile.y0);
        EXPECT_TRUE(written == 0 || written == pixels) << "tile " << i << " was left half done";
        finished += written == pixels;
    }
    return finished;
}

TEST(Cancel, before_the_start_renders_nothing) {
    Renderer renderer(Accel::build(busy_scene()), {2});
    auto target = Framebuffer::create(64, 64);
    RenderControl control;
    control.cancel();
    const auto result = renderer.render(*target, {}, &control);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_EQ(finished_tiles(*target), 0u);
    control.reset();
    EXPECT_TRUE(renderer.render(*target, {}, &control));
    EXPECT_EQ(control.progress(), 1.0);
}

TEST(Cancel, leaves_whole_tiles) {
    // Without a tree, so that there is time to cancel.
    Renderer renderer(Accel::build(busy_scene(), {AccelKind::brute, 1}), {2});
    auto target = Framebuffer::create(512, 512);
    RenderControl control;
    double seen_progress = 0.0;
    std::jthread watcher([&] {
        while ((seen_progress = control.progress()) < 0.05) std::this_thread::yield();
        control.cancel();
    });
    const auto result = renderer.render(*target, {}, &control);
    watcher.join();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    const uint32_t finished = finished_tiles(*target);
    EXPECT_GE(finished, 1024 / 20);
    EXPECT_LT(finished, 1024u);
    EXPECT_EQ(control.progress(), finished / 1024.0) << "progress counts just the finished tiles";
}

TEST(Renderers, work_side_by_side_on_one_scene) {
    const auto scene = busy_scene();
    const uint64_t expected = render(scene, 64, 48, 3, 1).radiance_hash();
    const auto accel = Accel::build(scene);
    std::vector<std::jthread> threads;
    std::atomic<int> wrong{0};
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            Renderer renderer(accel, {2});
            auto target = Framebuffer::create(64, 48);
            RenderOptions options;
            options.max_depth = 3;
            for (int frame = 0; frame < 5; ++frame) {
                if (!renderer.render(*target, options) || target->radiance_hash() != expected) ++wrong;
            }
        });
    }
    threads.clear();
    EXPECT_EQ(wrong, 0);
}

TEST(Renderers, take_turns_when_two_threads_share_one) {
    const auto scene = busy_scene();
    Renderer renderer(Accel::build(scene), {2});
    const uint64_t expected = render(scene, 40, 30, 4, 1).radiance_hash();
    std::atomic<int> wrong{0};
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 3; ++i) {
            threads.emplace_back([&] {
                auto target = Framebuffer::create(40, 30);
                for (int frame = 0; frame < 5; ++frame) {
                    if (!renderer.render(*target) || target->radiance_hash() != expected) ++wrong;
                }
            });
        }
    }
    EXPECT_EQ(wrong, 0);
}

} // namespace
} // namespace glint::test
