// The governor, the camera's control and the refiner are those of C++, through C.
#include <cmath>
#include <cstring>

#include <glint/camera_control.hpp>
#include <glint/governor.hpp>
#include <glint/read.hpp>

#include "c/c_handles.hpp"

namespace glint::test {
namespace {

constexpr const char *cornell_file = GLINT_SOURCE_DIR "/scenes/sdl/cornell.sdl";

Made<glint_scene> read_cornell() {
    return make<glint_scene>([](glint_scene **place) { return glint_scene_read(cornell_file, nullptr, place); });
}

TEST(CGovernor, gives_way_as_that_of_cpp_does) {
    glint_governor_options options = with_defaults(glint_governor_options_init);
    EXPECT_EQ(options.target_fps, 60.0);
    options.target_fps = 30.0;
    options.greatest_depth = 4;
    const auto governor =
        make<glint_governor>([&](glint_governor **place) { return glint_governor_create(&options, place); });
    ASSERT_EQ(governor.code, GLINT_OK) << governor.message();
    auto same = Governor::create({30.0, 0.25f, 0, 4});
    for (int frame = 0; frame < 40; ++frame) {
        glint_frame_quality quality;
        ASSERT_EQ(glint_governor_get_quality(governor.get(), &quality), GLINT_OK);
        EXPECT_EQ(quality.scale, same->quality().scale);
        EXPECT_EQ(quality.depth, same->quality().depth);
        const double render_s = 0.2 * quality.scale * quality.scale;
        const glint_frame_times times{render_s, 0.0, render_s + 0.002, 0.0};
        ASSERT_EQ(glint_governor_measured(governor.get(), &quality, &times), GLINT_OK);
        same->measured({quality.scale, quality.depth}, {render_s, 0.0, render_s + 0.002, 0.0});
    }
    EXPECT_LT(same->quality().scale, 0.6f);
    ASSERT_EQ(glint_governor_set_greatest_depth(governor.get(), 2), GLINT_OK);
    glint_frame_quality quality;
    ASSERT_EQ(glint_governor_get_quality(governor.get(), &quality), GLINT_OK);
    EXPECT_EQ(quality.depth, 2u);
}

TEST(CGovernor, refuses_what_no_frame_rate_is) {
    glint_governor_options options = with_defaults(glint_governor_options_init);
    options.target_fps = -1.0;
    const auto governor =
        make<glint_governor>([&](glint_governor **place) { return glint_governor_create(&options, place); });
    EXPECT_EQ(governor.code, GLINT_ERROR_BAD_INPUT);
    EXPECT_GT(governor.message().size(), 0u);
    glint_frame_quality quality;
    EXPECT_EQ(glint_governor_get_quality(governor.get(), &quality), GLINT_ERROR_INVALID_ARGUMENT);
}

TEST(CScaledSize, is_that_of_cpp) {
    uint32_t width_px = 7, height_px = 7;
    ASSERT_EQ(glint_scaled_size(1280, 720, 0.5f, &width_px, &height_px), GLINT_OK);
    EXPECT_EQ((PictureSize{width_px, height_px}), scaled_size(1280, 720, 0.5f));
    for (const float scale : {0.0f, -1.0f, 1.5f, NAN}) {
        EXPECT_EQ(glint_scaled_size(1280, 720, scale, &width_px, &height_px), GLINT_ERROR_INVALID_ARGUMENT);
    }
    EXPECT_EQ(glint_scaled_size(0, 720, 0.5f, &width_px, &height_px), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_scaled_size(1280, 720, 0.5f, nullptr, &height_px), GLINT_ERROR_INVALID_ARGUMENT);
}

TEST(CCameraControl, moves_the_camera_as_that_of_cpp_does) {
    const auto scene = read_cornell();
    const auto control = make<glint_camera_control>(
        [&](glint_camera_control **place) { return glint_camera_control_create(scene.get(), 0, 0, place); });
    ASSERT_EQ(control.code, GLINT_OK) << control.message();
    CameraControl same(read_scene(cornell_file)->scene);
    const auto expect_same = [&](const char *after) {
        glint_camera camera;
        ASSERT_EQ(glint_camera_control_get_camera(control.get(), &camera), GLINT_OK);
        const Camera expected = same.camera();
        EXPECT_EQ(std::memcmp(&camera, &expected, sizeof camera), 0) << after;
    };
    expect_same("nothing");
    ASSERT_EQ(glint_camera_control_orbit(control.get(), 0.1, -0.2), GLINT_OK);
    same.orbit({0.1, -0.2});
    expect_same("an orbit");
    ASSERT_EQ(glint_camera_control_pan(control.get(), 0.5, 0.5, 0.6, 0.4, 3.0), GLINT_OK);
    same.pan({0.5, 0.5}, {0.6, 0.4}, 3.0);
    expect_same("panning");
    ASSERT_EQ(glint_camera_control_zoom(control.get(), 0.2, 0.3, 0.7, INFINITY), GLINT_OK);
    same.zoom({0.2, 0.3}, 0.7);
    expect_same("zooming");
    ASSERT_EQ(glint_camera_control_fly(control.get(), 0.1, 0.2, 0.3, 0.5), GLINT_OK);
    same.fly({0.1, 0.2, 0.3}, 0.5);
    expect_same("a flight");
    ASSERT_EQ(glint_camera_control_resize(control.get(), 640, 200), GLINT_OK);
    same.resize(640, 200);
    expect_same("another window");
    ASSERT_EQ(glint_camera_control_frame(control.get()), GLINT_OK);
    same.frame();
    expect_same("framing");
    ASSERT_EQ(glint_camera_control_reset(control.get()), GLINT_OK);
    same.reset();
    expect_same("a reset");
    EXPECT_EQ(glint_camera_control_resize(control.get(), 0, 200), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(glint_last_error_message(control.get()), "the window has no pixels");
    EXPECT_EQ(make<glint_camera_control>([&](glint_camera_control **place) {
                  return glint_camera_control_create(scene.get(), 5, 0, place);
              }).code,
              GLINT_ERROR_INVALID_ARGUMENT);
}

TEST(CRefiner, smooths_a_picture_in_17_passes) {
    const auto scene = read_cornell();
    const auto renderer = renderer_of(scene.get());
    const auto picture = framebuffer_of(48, 32);
    const auto refiner =
        make<glint_refiner>([&](glint_refiner **place) { return glint_refiner_create(nullptr, place); });
    ASSERT_EQ(refiner.code, GLINT_OK);
    int passes = 0;
    uint64_t first = 0;
    for (; !glint_refiner_is_done(refiner.get()) && passes < 100; ++passes) {
        ASSERT_EQ(glint_refiner_next(refiner.get(), renderer.get(), picture.get(), nullptr), GLINT_OK);
        if (passes == 0) first = glint_framebuffer_pixel_hash(picture.get());
    }
    EXPECT_EQ(passes, 17);
    EXPECT_EQ(glint_refiner_samples_done(refiner.get()), 16u);
    EXPECT_NE(glint_framebuffer_pixel_hash(picture.get()), first);

    ASSERT_EQ(glint_refiner_restart(refiner.get(), nullptr), GLINT_OK);
    EXPECT_EQ(glint_refiner_is_done(refiner.get()), 0);
    glint_refiner_cancel(refiner.get()); // the next pass, and only that
    EXPECT_EQ(glint_refiner_next(refiner.get(), renderer.get(), picture.get(), nullptr), GLINT_ERROR_CANCELLED);
    ASSERT_EQ(glint_refiner_next(refiner.get(), renderer.get(), picture.get(), nullptr), GLINT_OK);
    EXPECT_EQ(glint_framebuffer_pixel_hash(picture.get()), first);
    EXPECT_EQ(glint_refiner_next(refiner.get(), nullptr, picture.get(), nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(glint_last_error_message(refiner.get()), "there is no renderer");
    EXPECT_EQ(glint_refiner_is_done(nullptr), 0);
    EXPECT_EQ(glint_refiner_samples_done(nullptr), 0u);
}

} // namespace
} // namespace glint::test
