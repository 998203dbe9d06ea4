// The whole loop, off screen: what is on the surface is what render() makes, whatever happens in between.
#include "viewer/viewer.hpp"

#include <gtest/gtest.h>

#include <glint/animation.hpp>

#include "support/meshes.hpp"
#include "support/picture.hpp"

namespace glint::viewer {
namespace {

/// An off-screen window that remembers what was on it at each swap.
class WatchedWindow final : public Window {
public:
    explicit WatchedWindow(std::unique_ptr<Window> window) : window_(std::move(window)) {}

    [[nodiscard]] std::string kind() const override { return window_->kind(); }
    [[nodiscard]] std::string gl_description() const override { return window_->gl_description(); }
    [[nodiscard]] uint32_t width_px() const override { return window_->width_px(); }
    [[nodiscard]] uint32_t height_px() const override { return window_->height_px(); }
    void take_events(double wait_s, std::vector<InputEvent> &events) override {
        has_waited = wait_s > 0.0;
        window_->take_events(wait_s, events);
    }
    Status resize(uint32_t width_px, uint32_t height_px) override { return window_->resize(width_px, height_px); }
    Result<gles::ProcLoader> context(bool is_lost) override {
        losses += is_lost ? 1 : 0;
        return window_->context(is_lost);
    }
    Status swap() override {
        auto pixels = window_->read_back();
        if (!pixels) return pixels.error();
        shown = std::move(*pixels);
        ++swaps;
        swaps_after_waiting += has_waited ? 1 : 0;
        return window_->swap();
    }
    Result<std::vector<uint8_t>> read_back() override { return window_->read_back(); }

    std::vector<uint8_t> shown;
    int swaps = 0, swaps_after_waiting = 0, losses = 0;
    bool has_waited = false; // when it was last asked for events

private:
    std::unique_ptr<Window> window_;
};

class ViewerTest : public testing::Test {
protected:
    void SetUp() override {
        auto window = open_offscreen(96, 64);
        if (!window) GTEST_SKIP() << window.error().text();
        window_.emplace(std::move(*window));
        SceneBuilder builder;
        Material material;
        material.color = {0.2f, 0.6f, 1.0f};
        material.ambient = 1.0f;
        builder.add_object({"square", test::square({0.1f, 0.0f, 0.0f}, 0.7f), material});
        builder.set_ambient(0.7f);
        builder.set_picture({.width_px = 96, .height_px = 64});
        builder.set_camera(Camera::through_window({0.3f, 0.1f, 5.0f}, -1.5f, -1.0f, 1.5f, 1.0f));
        options_.scene = *builder.build();
        options_.accel = Accel::build(options_.scene);
        options_.threads = 2;
        options_.shows_figures = false;
        options_.say = [](const std::string &line) { ADD_FAILURE() << line; };
    }

    void script(std::string_view text) {
        auto parsed = Script::parse(text, "script");
        ASSERT_TRUE(parsed.ok()) << parsed.error().text();
        options_.script = std::move(*parsed);
    }
    FrameLog run() {
        Result<FrameLog> log = view(*window_, options_);
        EXPECT_TRUE(log.ok()) << (log.ok() ? "" : log.error().text());
        return log.ok() ? std::move(*log) : FrameLog();
    }
    void expect_shown(const Framebuffer &picture) {
        const size_t bytes = picture.rgba8_stride_bytes() * picture.height_px();
        ASSERT_EQ(window_->shown.size(), bytes);
        const auto at = std::mismatch(window_->shown.begin(), window_->shown.end(), picture.rgba8()).first;
        const auto byte = static_cast<size_t>(at - window_->shown.begin());
        EXPECT_EQ(byte, bytes) << "first another byte at pixel " << byte / 4 % picture.width_px() << ", "
                               << byte / 4 / picture.width_px();
    }
    Framebuffer rendered(uint32_t width_px, uint32_t height_px, uint32_t samples) {
        auto picture = Framebuffer::create(width_px, height_px);
        RenderOptions how;
        CameraControl camera(options_.scene, 96, 64);
        camera.resize(width_px, height_px);
        how.camera = camera.camera();
        how.max_depth = options_.depth;
        how.samples_per_pixel = samples;
        EXPECT_TRUE(Renderer(options_.accel).render(*picture, how).ok());
        return std::move(*picture);
    }

    std::optional<WatchedWindow> window_;
    ViewOptions options_;
};

TEST_F(ViewerTest, first_shows_the_picture_that_render_makes) {
    options_.frames = 1;
    const FrameLog log = run();
    EXPECT_EQ(log.count(), 1u);
    expect_shown(test::render(options_.accel, 96, 64, 1, {}));
}

TEST_F(ViewerTest, at_rest_ends_with_sixteen_samples) {
    options_.ends_at_rest = true;
    const FrameLog log = run();
    EXPECT_EQ(log.frames().back().samples, 16u);
    expect_shown(rendered(96, 64, 16));
}

TEST_F(ViewerTest, shows_the_picture_again_after_every_loss_of_its_context) {
    script("0.01 lose-context\n0.1 lose-context\n0.2 lose-context\n0.35 lose-context\n");
    options_.ends_at_rest = true;
    run();
    EXPECT_EQ(window_->losses, 4);
    expect_shown(rendered(96, 64, 16));
}

TEST_F(ViewerTest, takes_every_size_while_it_runs) {
    script("0.02 resize 33 65\n0.05 resize 1 1\n0.1 resize 200 20\n0.12 resize 120 64\n");
    options_.ends_at_rest = true;
    run();
    expect_shown(rendered(120, 64, 16));
}

TEST_F(ViewerTest, comes_back_with_r_whatever_was_done_before) {
    script(
        "0 drag left 10 10 80 40 0.1\n0.05 wheel 3 20 20\n0.1 key w down\n0.2 key w up\n0.2 drag right 5 5 60 60 0.05\n"
        "0.3 key f\n0.3 key h\n0.35 key h\n0.4 press left 40 30\n0.4 release left 40 30\n"
        "0.5 press left 40 30\n0.5 release left 40 30\n0.6 key r\n");
    options_.ends_at_rest = true;
    const FrameLog log = run();
    EXPECT_GT(log.count(), 17u);
    expect_shown(rendered(96, 64, 16));
}

TEST_F(ViewerTest, draws_over_the_picture_only_what_is_asked_for) {
    script("0 key tab\n");
    options_.ends_at_rest = true;
    run();
    const std::vector<uint8_t> with_figures = window_->shown;
    const Framebuffer picture = rendered(96, 64, 16);
    EXPECT_FALSE(std::equal(with_figures.begin(), with_figures.end(), picture.rgba8()));
    script("0 key tab\n0.1 key tab\n");
    run();
    expect_shown(picture);
}

TEST_F(ViewerTest, closes_when_it_is_told_to) {
    script("0.05 close\n");
    run();
    script("0.05 key escape\n");
    run();
    options_.script.reset();
    int turns = 0;
    options_.is_interrupted = [&] { return ++turns > 10; };
    run();
}

TEST_F(ViewerTest, is_paused_without_a_better_picture) {
    script("0 key space\n0.4 close\n");
    const FrameLog log = run();
    for (const ShownFrame &frame : log.frames()) EXPECT_FALSE(frame.refines);
}

TEST_F(ViewerTest, knows_frames_that_follow_each_other_however_slow_they_are) {
    auto window = open_offscreen(1600, 1200);
    ASSERT_TRUE(window.ok()) << window.error().text();
    window_.emplace(std::move(*window));
    options_.isa = Isa::scalar;
    options_.threads = 1;
    options_.frames = 6;
    script("0 key d down\n");
    const FrameLog log = run();
    ASSERT_EQ(log.count(), 6u);
    EXPECT_GE(log.intervals_s().size() + 2, log.count()); // all but the first, and the one before it moved
    for (const ShownFrame &frame : log.frames()) {
        if (frame.interval_s > 0.0) {
            EXPECT_LT(frame.wait_s, frame.interval_s);
        }
    }
}

TEST_F(ViewerTest, shows_a_finished_frame_before_it_waits_for_the_next) {
    options_.fps = 40.0;
    script("0 key d down\n0.5 key d up\n0.6 close\n");
    const FrameLog log = run();
    EXPECT_GT(log.intervals_s().size(), 2u);
    EXPECT_EQ(window_->swaps_after_waiting, 0);
}

TEST_F(ViewerTest, plays_a_scene_that_moves_and_rests_at_its_end) {
    SceneBuilder builder;
    Material material;
    material.color = {0.9f, 0.6f, 0.1f};
    material.ambient = 1.0f;
    Object object{"square", test::square({0.0f, 0.0f, 0.0f}, 0.4f), material};
    object.pose = RigidTransform{};
    builder.add_object(object);
    builder.set_ambient(1.0f);
    builder.set_picture({.width_px = 96, .height_px = 64});
    builder.set_camera(Camera::through_window({0.0f, 0.0f, 5.0f}, -1.5f, -1.0f, 1.5f, 1.0f));
    Animation animation;
    ObjectMotion motion;
    motion.moves = {{0.0, {-0.5f, 0.0f, 0.0f}}, {0.3, {0.5f, 0.2f, 0.0f}}};
    animation.objects.push_back(motion);
    builder.set_animation(std::make_shared<Animation>(animation));
    auto scene = builder.build();
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    options_.scene = *scene;
    options_.accel = Accel::build(options_.scene);
    options_.ends_at_rest = true;
    const FrameLog log = run();
    EXPECT_GT(log.count(), 18u) << "more than the passes at rest";
    const auto end = scene_at(*scene, 0.3);
    ASSERT_TRUE(end.ok());
    options_.accel = Accel::build(*end);
    expect_shown(rendered(96, 64, 16));
}

TEST_F(ViewerTest, changes_depth_and_threads) {
    script("0.01 key 3\n0.02 key +\n0.03 key -\n0.04 key -\n0.05 key -\n0.06 key 0\n");
    options_.ends_at_rest = true;
    const FrameLog log = run();
    EXPECT_EQ(log.frames().back().depth, 0u);
    options_.depth = 0;
    expect_shown(rendered(96, 64, 16));
}

TEST_F(ViewerTest, refuses_a_frame_rate_that_is_none) {
    options_.fps = 0.0;
    const Result<FrameLog> log = view(*window_, options_);
    ASSERT_FALSE(log.ok());
    EXPECT_EQ(log.error().code, ErrorCode::bad_input);
}

} // namespace
} // namespace glint::viewer
