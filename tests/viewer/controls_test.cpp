// What input means: each drag, key and click, and what is held.
#include "viewer/controls.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace glint::viewer {
namespace {

using Kind = InputEvent::Kind;

InputEvent mouse(Kind kind, double x, double y, Button button = Button::left) {
    InputEvent event;
    event.kind = kind;
    event.x = x;
    event.y = y;
    event.button = button;
    return event;
}
InputEvent key(Kind kind, Key which) {
    InputEvent event;
    event.kind = kind;
    event.key = which;
    return event;
}

class ControlsTest : public testing::Test {
protected:
    void drag(Button button, double x0, double y0, double x1, double y1) {
        controls_.handle(mouse(Kind::button_down, x0, y0, button));
        controls_.handle(mouse(Kind::move, x1, y1, button));
        controls_.handle(mouse(Kind::button_up, x1, y1, button));
    }
    void type(Key which) {
        controls_.handle(key(Kind::key_down, which));
        controls_.handle(key(Kind::key_up, which));
    }
    static bool same(const Camera &a, const Camera &b) {
        return a.eye == b.eye && a.top_left == b.top_left && a.right == b.right && a.down == b.down;
    }

    std::shared_ptr<const Scene> scene_ = [] {
        SceneBuilder builder;
        builder.add_object({"square", test::square({0.0f, 0.0f, 0.0f}, 1.0f), {}});
        builder.set_camera(Camera::through_window({0.0f, 0.0f, 5.0f}, -1.0f, -1.0f, 1.0f, 1.0f));
        return *builder.build();
    }();
    CameraControl camera_{scene_, 200, 100};
    std::optional<double> distance_ = 5.0;
    static ViewChoices chosen() {
        ViewChoices choices;
        choices.depth = 2;
        choices.threads = 4;
        return choices;
    }
    Controls controls_{camera_, chosen(), [this](double, double) { return distance_; }, 200, 100};
    Camera first_ = camera_.camera();
};

TEST_F(ControlsTest, left_drag_orbits_at_the_same_distance) {
    drag(Button::left, 100, 50, 150, 60);
    EXPECT_GT(controls_.moves(), 0u);
    EXPECT_FALSE(same(camera_.camera(), first_));
    EXPECT_NEAR(glm::length(camera_.eye() - camera_.pivot()), 5.0, 1e-6);
}

TEST_F(ControlsTest, right_drag_keeps_the_place_under_the_cursor) {
    drag(Button::right, 100, 50, 150, 60);
    const auto place = camera_.place_of({0.0, 0.0, 0.0});
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 0.75, 1e-6);
    EXPECT_NEAR(place->y, 0.6, 1e-6);
}

TEST_F(ControlsTest, wheel_zooms_to_the_cursor) {
    InputEvent wheel = mouse(Kind::wheel, 150, 50);
    wheel.amount = 3.0;
    const glm::dvec3 before = camera_.eye() + camera_.direction_to({0.75, 0.5}) * 5.0;
    controls_.handle(wheel);
    EXPECT_LT(glm::length(camera_.eye() - before), 5.0);
    const auto place = camera_.place_of(before);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 0.75, 1e-6);
    const uint64_t moves = controls_.moves();
    wheel.amount = 0.0;
    controls_.handle(wheel);
    EXPECT_EQ(controls_.moves(), moves);
}

TEST_F(ControlsTest, keys_fly_while_they_are_held_and_faster_with_shift) {
    controls_.advance(1.0);
    EXPECT_EQ(controls_.moves(), 0u);
    controls_.handle(key(Kind::key_down, Key::w));
    EXPECT_TRUE(controls_.is_moving());
    controls_.advance(0.1);
    const double slow = 5.0 - camera_.eye().z;
    EXPECT_GT(slow, 0.0);
    controls_.handle(key(Kind::key_down, Key::shift));
    controls_.advance(0.1);
    EXPECT_NEAR(5.0 - camera_.eye().z, 5.0 * slow, 1e-6); // four times as far again
    controls_.handle(key(Kind::key_up, Key::w));
    EXPECT_FALSE(controls_.is_moving());
    const uint64_t moves = controls_.moves();
    controls_.advance(1.0);
    EXPECT_EQ(controls_.moves(), moves);
}

TEST_F(ControlsTest, opposite_keys_cancel_out) {
    controls_.handle(key(Kind::key_down, Key::a));
    controls_.handle(key(Kind::key_down, Key::d));
    controls_.advance(1.0);
    EXPECT_TRUE(same(camera_.camera(), first_));
}

TEST_F(ControlsTest, r_goes_back_to_the_last_bit) {
    drag(Button::left, 100, 50, 150, 60);
    type(Key::r);
    EXPECT_TRUE(same(camera_.camera(), first_));
}

TEST_F(ControlsTest, f_frames_the_scene) {
    type(Key::f);
    for (const double x : {-1.0, 1.0}) {
        const auto place = camera_.place_of({x, x, 0.0});
        ASSERT_TRUE(place);
        EXPECT_GT(place->y, 0.0);
        EXPECT_LT(place->y, 1.0);
    }
    EXPECT_FALSE(same(camera_.camera(), first_));
}

TEST_F(ControlsTest, keys_choose) {
    type(Key::digit7);
    EXPECT_EQ(controls_.choices().depth, 7u);
    type(Key::digit0);
    EXPECT_EQ(controls_.choices().depth, 0u);
    type(Key::plus);
    EXPECT_EQ(controls_.choices().threads, 5u);
    for (int i = 0; i < 10; ++i) type(Key::minus);
    EXPECT_EQ(controls_.choices().threads, 1u);
    type(Key::space);
    EXPECT_TRUE(controls_.choices().is_paused);
    type(Key::tab);
    EXPECT_FALSE(controls_.choices().shows_figures);
    type(Key::h);
    EXPECT_TRUE(controls_.choices().shows_help);
    type(Key::p);
    type(Key::p);
    EXPECT_EQ(controls_.choices().screenshots, 2u);
    EXPECT_FALSE(controls_.choices().closes);
    type(Key::escape);
    EXPECT_TRUE(controls_.choices().closes);
    EXPECT_EQ(controls_.moves(), 0u);
}

TEST_F(ControlsTest, a_click_inspects_a_pixel_and_a_second_one_ends_it) {
    drag(Button::left, 100, 50, 101, 51); // a hand trembles
    ASSERT_TRUE(controls_.choices().inspected);
    EXPECT_EQ(*controls_.choices().inspected, (PixelPlace{100, 50}));
    EXPECT_EQ(controls_.moves(), 0u);
    type(Key::down);
    type(Key::down);
    type(Key::up);
    EXPECT_EQ(controls_.choices().first_ray, 1u);
    drag(Button::left, 100, 50, 100, 50);
    EXPECT_FALSE(controls_.choices().inspected);
    drag(Button::left, 500, -50, 500, -50);
    EXPECT_EQ(*controls_.choices().inspected, (PixelPlace{199, 0}));
    drag(Button::left, 100, 50, 150, 50); // another picture
    EXPECT_FALSE(controls_.choices().inspected);
}

TEST_F(ControlsTest, one_button_at_a_time_drags) {
    controls_.handle(mouse(Kind::button_down, 10, 10, Button::left));
    controls_.handle(mouse(Kind::button_down, 10, 10, Button::right));
    controls_.handle(mouse(Kind::move, 50, 50));
    EXPECT_TRUE(controls_.is_moving());
    EXPECT_NEAR(glm::length(camera_.eye() - camera_.pivot()), 5.0, 1e-6); // it orbits
    controls_.handle(mouse(Kind::button_up, 50, 50, Button::right));
    EXPECT_TRUE(controls_.is_moving());
    controls_.handle(mouse(Kind::button_up, 50, 50, Button::left));
    EXPECT_FALSE(controls_.is_moving());
}

TEST_F(ControlsTest, two_fingers_pan_and_pinch) {
    const auto finger = [&](Kind kind, uint64_t id, double x, double y) {
        InputEvent event = mouse(kind, x, y);
        event.finger = id;
        controls_.handle(event);
    };
    finger(Kind::finger_down, 1, 90, 50);
    finger(Kind::finger_down, 2, 110, 50);
    finger(Kind::finger_move, 1, 80, 50);
    finger(Kind::finger_move, 2, 120, 50);
    EXPECT_NEAR(glm::length(camera_.eye() - camera_.pivot()), 2.5, 1e-6); // twice as far apart, half as far away
    EXPECT_TRUE(controls_.is_moving());
    finger(Kind::finger_up, 1, 80, 50);
    finger(Kind::finger_up, 2, 120, 50);
    EXPECT_FALSE(controls_.is_moving());
}

TEST_F(ControlsTest, a_new_size_is_a_new_picture) {
    InputEvent resize;
    resize.kind = Kind::resize;
    resize.width_px = 400;
    resize.height_px = 100;
    controls_.handle(resize);
    EXPECT_EQ(controls_.moves(), 1u);
    EXPECT_EQ(camera_.camera().down, first_.down);
    EXPECT_NEAR(camera_.camera().right.x, 2.0f * first_.right.x, 1e-5f);
}

TEST(HelpLines, tell_every_key_once) {
    EXPECT_GE(help_lines().size(), 12u);
    for (const HudKey &a : help_lines()) {
        EXPECT_FALSE(a.keys.empty());
        EXPECT_FALSE(a.meaning.empty());
    }
}

} // namespace
} // namespace glint::viewer
