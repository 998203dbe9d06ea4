// Fingers: one moves, two move and pinch, a third waits.
#include "viewer/touch.hpp"

#include <gtest/gtest.h>

namespace glint::viewer {
namespace {

InputEvent finger(InputEvent::Kind kind, uint64_t id, double x, double y) {
    InputEvent event;
    event.kind = kind;
    event.finger = id;
    event.x = x;
    event.y = y;
    return event;
}
using Kind = InputEvent::Kind;

TEST(Touch, of_one_finger_is_a_drag) {
    Touch touch;
    EXPECT_FALSE(touch.touched());
    EXPECT_EQ(touch.handle(finger(Kind::finger_down, 7, 10, 20)).kind, TouchMove::Kind::none);
    EXPECT_TRUE(touch.touched());
    const TouchMove move = touch.handle(finger(Kind::finger_move, 7, 15, 26));
    EXPECT_EQ(move.kind, TouchMove::Kind::one);
    EXPECT_EQ(move.from_x, 10.0);
    EXPECT_EQ(move.from_y, 20.0);
    EXPECT_EQ(move.to_x, 15.0);
    EXPECT_EQ(move.to_y, 26.0);
    EXPECT_EQ(touch.handle(finger(Kind::finger_up, 7, 15, 26)).kind, TouchMove::Kind::none);
    EXPECT_FALSE(touch.touched());
}

TEST(Touch, of_two_fingers_moves_their_middle_and_spreads) {
    Touch touch;
    static_cast<void>(touch.handle(finger(Kind::finger_down, 1, 100, 100)));
    static_cast<void>(touch.handle(finger(Kind::finger_down, 2, 200, 100)));
    const TouchMove move = touch.handle(finger(Kind::finger_move, 2, 300, 100));
    EXPECT_EQ(move.kind, TouchMove::Kind::two);
    EXPECT_EQ(move.from_x, 150.0);
    EXPECT_EQ(move.to_x, 200.0);
    EXPECT_EQ(move.to_y, 100.0);
    EXPECT_DOUBLE_EQ(move.spread, 2.0);
    // Both on one place: no factor comes of it.
    EXPECT_DOUBLE_EQ(touch.handle(finger(Kind::finger_move, 2, 100, 100)).spread, 1.0 / 200.0);
    EXPECT_DOUBLE_EQ(touch.handle(finger(Kind::finger_move, 2, 100, 100)).spread, 1.0);
}

TEST(Touch, of_a_third_finger_waits) {
    Touch touch;
    for (const uint64_t id : {1, 2, 3}) {
        static_cast<void>(touch.handle(finger(Kind::finger_down, id, 100.0 * static_cast<double>(id), 0)));
    }
    EXPECT_EQ(touch.handle(finger(Kind::finger_move, 3, 5, 5)).kind, TouchMove::Kind::none);
    static_cast<void>(touch.handle(finger(Kind::finger_up, 1, 100, 0)));
    const TouchMove move = touch.handle(finger(Kind::finger_move, 3, 10, 5));
    EXPECT_EQ(move.kind, TouchMove::Kind::two);
    EXPECT_DOUBLE_EQ(move.from_x, 102.5); // of the second and the third, where that was last
}

TEST(Touch, of_unknown_fingers_means_nothing) {
    Touch touch;
    EXPECT_EQ(touch.handle(finger(Kind::finger_move, 1, 5, 5)).kind, TouchMove::Kind::none);
    EXPECT_EQ(touch.handle(finger(Kind::finger_up, 1, 5, 5)).kind, TouchMove::Kind::none);
    EXPECT_EQ(touch.handle(finger(Kind::wheel, 1, 5, 5)).kind, TouchMove::Kind::none);
    EXPECT_FALSE(touch.touched());
}

} // namespace
} // namespace glint::viewer
