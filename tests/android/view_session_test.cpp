// A view's session without Java: what is on the surface is what the renderer makes, whatever a phone does in between.
#include "android/session/view_session.hpp"

#include <cstring>
#include <thread>

#include <gtest/gtest.h>

#include <glint/animation.hpp>
#include <glint/egl/surface.hpp>
#include <glint/read.hpp>

#include "support/picture.hpp"

namespace glint::android {
namespace {

using viewer::InputEvent;

constexpr uint32_t size_px = 96;

class ViewSessionTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(open("cornell")); }

    void open(const std::string &name, const ViewOptions &options = {}) {
        if (!new_surface()) return;
        auto file = read_scene(std::string(GLINT_SOURCE_DIR "/scenes/sdl/") + name + ".sdl");
        ASSERT_TRUE(file.ok()) << file.error().text();
        scene_ = file->scene;
        accel_ = Accel::build(scene_);
        auto session = ViewSession::create(accel_, scene_, options);
        ASSERT_TRUE(session.ok()) << session.error().text();
        session_ = std::move(*session);
        session_->context_created();
        session_->resize(size_px, size_px);
    }

    /// Another context in place of the one before, current.
    bool new_surface() {
        surface_.reset();
        auto surface = egl::create_surfaceless(size_px, size_px);
        if (surface) {
            surface_ = std::move(*surface);
        } else {
            [&] { GTEST_SKIP() << surface.error().text(); }();
        }
        return surface_ != nullptr;
    }

    /// Draws until nothing is left to be drawn.
    void draw_to_the_end() {
        for (int i = 0; i < 10'000; ++i) {
            const Result<double> again = session_->draw();
            ASSERT_TRUE(again.ok()) << again.error().text();
            if (*again == ViewSession::never_again) return;
            std::this_thread::sleep_for(std::chrono::duration<double>(*again));
        }
        FAIL() << "it never comes to rest";
    }

    void draw_once() {
        const Result<double> again = session_->draw();
        ASSERT_TRUE(again.ok()) << again.error().text();
    }

    std::vector<uint8_t> shown() {
        auto pixels = surface_->read_back();
        EXPECT_TRUE(pixels.ok());
        return pixels.ok() ? *pixels : std::vector<uint8_t>();
    }

    /// What refinement of that camera ends with.
    std::vector<uint8_t> refined(const Camera &camera, uint32_t width_px = size_px, uint32_t height_px = size_px) {
        RenderOptions how;
        how.camera = camera;
        auto picture = Framebuffer::create(width_px, height_px, false);
        Renderer renderer(accel_);
        Refiner refiner(how);
        while (!refiner.done()) EXPECT_TRUE(refiner.next(renderer, *picture).ok());
        const size_t bytes = picture->rgba8_stride_bytes() * height_px;
        return {picture->rgba8(), picture->rgba8() + bytes};
    }

    void finger(InputEvent::Kind kind, uint64_t which, double x, double y) {
        InputEvent event;
        event.kind = kind;
        event.finger = which;
        event.x = x;
        event.y = y;
        session_->handle(event);
    }

    std::unique_ptr<gles::Surface> surface_;
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const Accel> accel_;
    std::unique_ptr<ViewSession> session_;
};

TEST_F(ViewSessionTest, comes_to_rest_with_the_refined_picture_of_the_scene) {
    draw_to_the_end();
    EXPECT_EQ(shown(), refined(scene_->camera()));
    const ViewFigures figures = session_->figures();
    EXPECT_TRUE(figures.is_final);
    EXPECT_EQ(figures.samples, Refiner::samples);
    EXPECT_EQ(figures.width_px, size_px);
    EXPECT_EQ(figures.depth, scene_->picture().max_depth);
    EXPECT_EQ(figures.context_losses, 0u);
    // At rest nothing is traced, but what is on the surface may be asked for again.
    draw_once();
    EXPECT_EQ(session_->figures().frames, figures.frames);
}

TEST_F(ViewSessionTest, one_finger_orbits_and_going_back_gives_the_first_picture) {
    draw_to_the_end();
    const auto first = shown();
    finger(InputEvent::Kind::finger_down, 7, 40, 40);
    finger(InputEvent::Kind::finger_move, 7, 52, 44);
    finger(InputEvent::Kind::finger_up, 7, 52, 44);
    draw_to_the_end();
    CameraControl camera(scene_);
    camera.orbit({12.0 / size_px, 4.0 / size_px});
    EXPECT_EQ(shown(), refined(camera.camera()));
    EXPECT_NE(shown(), first);

    InputEvent back;
    back.kind = InputEvent::Kind::key_down;
    back.key = viewer::Key::r;
    session_->handle(back);
    draw_to_the_end();
    EXPECT_EQ(shown(), first);
}

TEST_F(ViewSessionTest, two_fingers_pan_and_pinch) {
    finger(InputEvent::Kind::finger_down, 0, 30, 40);
    finger(InputEvent::Kind::finger_down, 1, 60, 40);
    finger(InputEvent::Kind::finger_move, 1, 75, 40);
    finger(InputEvent::Kind::finger_up, 0, 30, 40);
    finger(InputEvent::Kind::finger_up, 1, 75, 40);
    draw_to_the_end();
    CameraControl camera(scene_);
    const double y = 40.0 / size_px, from = 45.0 / size_px, to = 52.5 / size_px;
    camera.pan({from, y}, {to, y});
    camera.zoom({to, y}, 30.0 / 45.0);
    EXPECT_EQ(shown(), refined(camera.camera()));
}

TEST_F(ViewSessionTest, waits_for_a_finger_that_rests_and_refines_when_it_is_lifted) {
    draw_to_the_end();
    finger(InputEvent::Kind::finger_down, 0, 30, 40);
    finger(InputEvent::Kind::finger_move, 0, 31, 40);
    draw_to_the_end();
    EXPECT_EQ(session_->figures().samples, 1u);
    EXPECT_FALSE(session_->figures().is_final);
    finger(InputEvent::Kind::finger_up, 0, 31, 40);
    draw_to_the_end();
    EXPECT_EQ(session_->figures().samples, Refiner::samples);
}

TEST_F(ViewSessionTest, shows_the_same_in_a_new_context) {
    draw_to_the_end();
    const auto before = shown();
    const uint64_t frames = session_->figures().frames;
    for (uint64_t losses = 1; losses <= 3; ++losses) {
        ASSERT_TRUE(new_surface());
        session_->context_created();
        draw_once();
        EXPECT_EQ(shown(), before);
        EXPECT_EQ(session_->figures().context_losses, losses);
    }
    EXPECT_EQ(session_->figures().frames, frames) << "a picture that is there was traced again";
}

TEST_F(ViewSessionTest, says_that_its_context_is_not_current_and_goes_on_when_it_is) {
    draw_to_the_end();
    const auto before = shown();
    auto other = egl::create_surfaceless(8, 8);
    ASSERT_TRUE(other.ok());
    const Result<double> drawn = session_->draw();
    ASSERT_FALSE(drawn.ok());
    EXPECT_NE(drawn.error().text().find("not current"), std::string::npos) << drawn.error().text();
    other->reset();
    ASSERT_TRUE(surface_->make_current().ok());
    session_->context_created();
    draw_once();
    EXPECT_EQ(shown(), before);
}

TEST_F(ViewSessionTest, draws_once_it_has_a_context) {
    session_ = std::move(*ViewSession::create(accel_, scene_, {}));
    EXPECT_EQ(*session_->draw(), ViewSession::never_again) << "it has no size yet";
    session_->resize(size_px, size_px);
    EXPECT_FALSE(session_->draw().ok());
    session_->context_created();
    draw_to_the_end();
    EXPECT_EQ(shown(), refined(scene_->camera()));
}

TEST_F(ViewSessionTest, fills_a_view_of_another_shape) {
    ASSERT_TRUE(surface_->resize(120, 50).ok());
    session_->resize(120, 50);
    draw_to_the_end();
    CameraControl camera(scene_);
    camera.resize(120, 50);
    EXPECT_EQ(shown(), refined(camera.camera(), 120, 50));
}

TEST_F(ViewSessionTest, makes_again_what_it_gave_up) {
    draw_to_the_end();
    const auto before = shown();
    session_->trim();
    draw_to_the_end();
    EXPECT_EQ(shown(), before);
}

TEST_F(ViewSessionTest, plays_a_scene_that_moves_to_its_end) {
    auto with_eye = std::make_shared<Animation>();
    const Point eye = scene_->camera().eye;
    with_eye->eye.places = {{0.0, eye}, {0.3, eye + Vector{0.2f, 0.0f, 0.0f}}};
    SceneBuilder builder;
    for (const Object &object : scene_->objects()) builder.add_object(object);
    for (const Light &light : scene_->lights()) builder.add_light(light);
    builder.set_camera(scene_->camera()).set_picture(scene_->picture()).set_animation(with_eye);
    auto moving = builder.build();
    ASSERT_TRUE(moving.ok()) << moving.error().text();
    scene_ = *moving;
    accel_ = Accel::build(scene_);
    session_ = std::move(*ViewSession::create(accel_, scene_, {}));
    session_->context_created();
    session_->resize(size_px, size_px);
    draw_to_the_end();
    const auto last = scene_at(scene_, 0.3);
    ASSERT_TRUE(last.ok());
    EXPECT_EQ(shown(), refined((*last)->camera()));
    EXPECT_GT(session_->figures().frames, 18u) << "fewer than one moving picture and the passes at rest";
}

TEST_F(ViewSessionTest, gives_up_resolution_while_it_moves_and_brings_it_back_at_rest) {
    ViewOptions options;
    options.target_fps = 1000.0; // more than any machine that runs this keeps at this size
    options.depth = 10;
    options.threads = 1;
    ASSERT_NO_FATAL_FAILURE(open("glass", options));
    constexpr uint32_t large_px = 320;
    ASSERT_TRUE(surface_->resize(large_px, large_px).ok());
    session_->resize(large_px, large_px);
    finger(InputEvent::Kind::finger_down, 0, 30, 40);
    for (int i = 0; i < 40; ++i) {
        finger(InputEvent::Kind::finger_move, 0, 31 + i % 2, 40);
        draw_once();
    }
    EXPECT_LT(session_->figures().width_px, large_px);
    EXPECT_GT(session_->figures().frames_a_second, 1.0);
    finger(InputEvent::Kind::finger_up, 0, 31, 40);
    const auto deadline = viewer::Clock::now() + std::chrono::seconds(30);
    while (session_->figures().width_px < large_px && viewer::Clock::now() < deadline) draw_once();
    EXPECT_EQ(session_->figures().width_px, large_px);
}

TEST_F(ViewSessionTest, takes_input_from_another_thread_while_it_draws) {
    std::thread hand([&] {
        finger(InputEvent::Kind::finger_down, 0, 30, 40);
        for (int i = 0; i < 200; ++i) {
            finger(InputEvent::Kind::finger_move, 0, 30 + i % 7, 40 + i % 3);
            if (i % 50 == 0) session_->trim();
            EXPECT_LE(session_->figures().samples, 16u);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        finger(InputEvent::Kind::finger_move, 0, 42, 44);
        finger(InputEvent::Kind::finger_up, 0, 42, 44);
    });
    for (int i = 0; i < 100; ++i) draw_once();
    hand.join();
    draw_to_the_end();
    EXPECT_TRUE(session_->figures().is_final);
}

TEST_F(ViewSessionTest, ends_without_its_context) {
    draw_to_the_end();
    surface_.reset();
    session_.reset();
    ASSERT_TRUE(new_surface());
}

TEST_F(ViewSessionTest, refuses_a_frame_rate_that_is_none) {
    ViewOptions options;
    options.target_fps = 0.0;
    EXPECT_FALSE(ViewSession::create(accel_, scene_, options).ok());
}

} // namespace
} // namespace glint::android
