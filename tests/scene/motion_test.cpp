// Scenes that differ in where their objects stand: what edits share, what is refused, where keyframes lead.
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <glint/glint.hpp>

#include "support/meshes.hpp"

namespace glint::test {
namespace {

constexpr double pi = 3.141592653589793;

/// Object 0 moves, object 1 does not.
SceneBuilder two_cubes() {
    const auto mesh = std::make_shared<const Mesh>(cube());
    Object moving{"moving", mesh, {}};
    moving.pose = RigidTransform{};
    SceneBuilder builder;
    builder.add_object(moving).add_object({"still", mesh, {}});
    return builder;
}

std::shared_ptr<const Scene> built(SceneBuilder builder) {
    auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return *scene;
}

void expect_near(const Point &a, const Point &b, float tolerance = 1e-6f) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

TEST(WithPoses, moves_objects_and_shares_their_meshes) {
    const auto scene = built(two_cubes());
    const RigidTransform pose = RigidTransform::turned({0, 0, 2}, pi / 2, {1, 0, 0}, {0, 0, 5});
    expect_near(pose.x, {0, 1, 0});
    expect_near(pose.translation, {1, -1, 5}); // the pivot stays, but for the move
    const auto moved = with_poses(scene, std::vector<ObjectPose>{{0, pose}});
    ASSERT_TRUE(moved) << moved.error().text();
    EXPECT_EQ((*moved)->objects()[0].mesh, scene->objects()[0].mesh);
    expect_near((*moved)->objects()[0].pose->translation, pose.translation);
    EXPECT_EQ(scene->objects()[0].pose, RigidTransform{}) << "the old scene has changed";
    EXPECT_FALSE((*moved)->objects()[1].pose);
    EXPECT_TRUE((*moved)->is_edit_of(*scene));
    EXPECT_FALSE(built(two_cubes())->is_edit_of(*scene));
}

TEST(WithPoses, rounds_away_what_is_left_of_a_rotation) {
    const auto scene = built(two_cubes());
    RigidTransform pose = RigidTransform::turned({1, 2, 3}, 0.7);
    pose.x *= 1.00002f;
    pose.y += pose.x * 0.00002f;
    const auto moved = with_poses(scene, std::vector<ObjectPose>{{0, pose}});
    ASSERT_TRUE(moved);
    const RigidTransform &kept = *(*moved)->objects()[0].pose;
    const auto dot = [](const Vector &a, const Vector &b) {
        return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z;
    };
    EXPECT_NEAR(dot(kept.x, kept.x), 1.0, 3e-7);
    EXPECT_NEAR(dot(kept.x, kept.y), 0.0, 3e-7);
    EXPECT_NEAR(dot(kept.y, kept.z), 0.0, 3e-7);
}

TEST(WithPoses, refuses_what_cannot_be) {
    const auto scene = built(two_cubes());
    const auto message = [&](uint32_t object, const std::function<void(RigidTransform &)> &change) {
        RigidTransform pose;
        change(pose);
        const auto moved = with_poses(scene, std::vector<ObjectPose>{{object, pose}});
        return moved ? std::string() : moved.error().text();
    };
    const auto nothing = [](RigidTransform &) {};
    EXPECT_NE(message(2, nothing).find("there is no object 2 among 2"), std::string::npos);
    EXPECT_NE(message(1, nothing).find("object 1 'still': does not move"), std::string::npos);
    const std::string no_rotation = "object 0 'moving': its axes are not of unit length";
    for (const auto &change : std::vector<std::function<void(RigidTransform &)>>{
             [](RigidTransform &p) {
                 p.x = {2, 0, 0};
             },
             [](RigidTransform &p) { p.z = -p.z; }, [](RigidTransform &p) { p.y = p.x; },
             [](RigidTransform &p) { p.y.x = std::numeric_limits<float>::quiet_NaN(); }}) {
        EXPECT_NE(message(0, change).find(no_rotation), std::string::npos) << message(0, change);
    }
    EXPECT_NE(message(0, [](RigidTransform &p) { p.translation.y = 2e12f; }).find("its translation"),
              std::string::npos);
    EXPECT_EQ(message(0, [](RigidTransform &p) { p.translation.y = 1e12f; }), "");
}

ObjectMotion spinning() {
    ObjectMotion motion;
    motion.moves = {{1.0, {0, 0, 0}}, {3.0, {4, 0, -2}}};
    motion.turns = {{0.0, {0, 1, 0}, 0.0}, {1.0, {0, 1, 0}, 4 * pi}, {2.0, {1, 0, 0}, pi / 2}};
    return motion;
}

TEST(Keyframes, go_evenly_from_one_place_to_the_next_and_rest_outside) {
    const ObjectMotion motion = spinning();
    expect_near(pose_at(motion, -5.0).translation, {0, 0, 0});
    expect_near(pose_at(motion, 1.5).translation, {1, 0, -0.5f});
    expect_near(pose_at(motion, 3.0).translation, {4, 0, -2});
    expect_near(pose_at(motion, 1e9).translation, {4, 0, -2});
}

TEST(Keyframes, turn_as_often_as_the_angle_says_about_one_axis) {
    const ObjectMotion motion = spinning();
    expect_near(pose_at(motion, 0.0625).x, {float(std::cos(pi / 4)), 0, float(-std::sin(pi / 4))});
    expect_near(pose_at(motion, 0.25).x, {-1, 0, 0});
    expect_near(pose_at(motion, 0.5).x, {1, 0, 0});
    expect_near(pose_at(motion, 0.75).x, {-1, 0, 0});
}

TEST(Keyframes, turn_the_shorter_way_between_axes) {
    const ObjectMotion motion = spinning();
    // From no turn, as two turns are, to a quarter about x.
    expect_near(pose_at(motion, 1.5).y, {0, float(std::cos(pi / 4)), float(std::sin(pi / 4))});
    expect_near(pose_at(motion, 1.5).x, {1, 0, 0});
    expect_near(pose_at(motion, 9.0).y, {0, 0, 1});
}

TEST(Keyframes, turn_about_the_pivot) {
    ObjectMotion motion = spinning();
    motion.pivot = {3, 0, 0};
    const RigidTransform pose = pose_at(motion, 0.25);
    expect_near(pose.translation, {6, 0, 0});
}

TEST(SceneAt, moves_objects_and_the_eye) {
    Animation animation;
    animation.objects = {spinning()};
    animation.eye.places = {{0.0, {0, 0, 6}}, {2.0, {2, 0, 6}}};
    SceneBuilder builder = two_cubes();
    const auto scene = built(builder.set_animation(std::make_shared<const Animation>(animation)));
    const auto later = scene_at(scene, 1.0);
    ASSERT_TRUE(later) << later.error().text();
    EXPECT_EQ((*later)->objects()[0].pose, pose_at(animation.objects[0], 1.0));
    expect_near((*later)->camera().eye, {1, 0, 6});
    EXPECT_EQ((*later)->camera().top_left, scene->camera().top_left);
    EXPECT_TRUE((*later)->is_edit_of(*scene));

    animation.eye.view = EyeMotion::View{{0, 0, 1}, {0, 1, 0}, 2, 2};
    const auto looking = scene_at(scene, animation, 2.0);
    ASSERT_TRUE(looking);
    const Camera expected = Camera::look_at({2, 0, 6}, {0, 0, 1}, {0, 1, 0}, 2, 2);
    EXPECT_EQ((*looking)->camera().right, expected.right);

    const auto still = built(two_cubes());
    EXPECT_EQ(*scene_at(still, 7.0), still);
}

TEST(SceneAt, refuses_what_cannot_be) {
    const auto scene = built(two_cubes());
    const auto message = [&](const std::function<void(Animation &)> &change, double time_s = 0.5) {
        Animation animation;
        animation.objects = {spinning()};
        change(animation);
        const auto moved = scene_at(scene, animation, time_s);
        SceneBuilder builder = two_cubes();
        const auto at_once = builder.set_animation(std::make_shared<const Animation>(animation)).build();
        if (time_s == 0.5 && animation.eye.places.empty()) {
            EXPECT_EQ(bool(moved), bool(at_once));
        }
        return moved ? std::string() : moved.error().text();
    };
    const auto has = [](const std::string &text, const char *part) { return text.find(part) != std::string::npos; };
    EXPECT_EQ(message([](Animation &) {}), "");
    EXPECT_TRUE(
        has(message([](Animation &a) { a.objects[0].object = 1; }), "object 1 'still': is animated, but has no pose"));
    EXPECT_TRUE(has(message([](Animation &a) { a.objects[0].object = 2; }), "moves object 2 of 2"));
    EXPECT_TRUE(
        has(message([](Animation &a) { a.objects[0].moves[1].time_s = 1.0; }), "times of its keys do not rise"));
    EXPECT_TRUE(has(message([](Animation &a) { a.objects[0].turns[0].axis = {0, 0, 0}; }), "key 0 is not finite"));
    EXPECT_TRUE(has(message([](Animation &a) { a.objects[0].moves[0].place.x = 2e12f; }), "key 0 is not finite"));
    EXPECT_TRUE(
        has(message([](Animation &a) { a.objects[0].pivot.x = std::numeric_limits<float>::infinity(); }), "pivot"));
    EXPECT_TRUE(has(message([](Animation &a) {
                        a.eye.places = {{0.0, {0, 0, 0}}};
                    }),
                    "lies in the plane of its window"));
    EXPECT_TRUE(has(message([](Animation &) {}, std::numeric_limits<double>::quiet_NaN()), "the time is not finite"));
}

} // namespace
} // namespace glint::test
