// The camera that a file's directives make together.
#include <cmath>

#include <gtest/gtest.h>

#include "sdl/small_scene.hpp"

namespace glint::test {
namespace {

class Cameras : public SmallScene {
protected:
    [[nodiscard]] Camera camera(const std::string &lines) const {
        return read("dialect mobile2013\nlight lamp.obj 1 1 1 1\nobject wall.obj 1 1 1 0 1 0 0 0 0\n" + lines)
            .scene->camera();
    }
};

void expect_near(const glm::vec3 &found, const glm::vec3 &expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-6f) << i;
}

TEST_F(Cameras, look_through_a_window_on_the_plane_z_0) {
    const Camera camera = this->camera("eye 1 2 5\northo -2 -1 3 4\n");
    EXPECT_EQ(camera.eye, Point(1, 2, 5));
    EXPECT_EQ(camera.top_left, Point(-2, 4, 0));
    EXPECT_EQ(camera.right, Vector(5, 0, 0));
    EXPECT_EQ(camera.down, Vector(0, -5, 0));
    EXPECT_EQ(this->camera("eye 1 2 -5\n").top_left, Point(-1, 1, 0)) << "from behind";
}

TEST_F(Cameras, may_see_the_world_reversed) {
    const Camera camera = this->camera("eye 0 0 5\northo 1 1 -1 -1\n");
    EXPECT_EQ(camera.top_left, Point(1, -1, 0));
    EXPECT_EQ(camera.right, Vector(-2, 0, 0));
    EXPECT_EQ(camera.down, Vector(0, 2, 0));
}

TEST_F(Cameras, look_at_a_target_through_a_window_at_distance_1) {
    const Camera camera = this->camera("eye 0 0 5\ntarget 0 0 0\n");
    EXPECT_EQ(camera.eye, Point(0, 0, 5));
    expect_near(camera.top_left, {-1, 1, 4});
    expect_near(camera.right, {2, 0, 0});
    expect_near(camera.down, {0, -2, 0});
}

TEST_F(Cameras, may_stand_in_the_plane_z_0_when_they_look_at_a_target) {
    const Camera camera = this->camera("eye 0 0 0\ntarget 7 0 0\nup 0 0 3\nwindow_size 1 .5\n");
    expect_near(camera.top_left, {1, 0.5f, 0.25f});
    expect_near(camera.right, {0, -1, 0});
    expect_near(camera.down, {0, 0, -0.5f});
}

TEST_F(Cameras, make_up_square_to_the_view) {
    const Camera camera = this->camera("eye 1 1 1\ntarget 1 0 0\nup 0 1 0\nwindow_size 2 2\n");
    const float h = std::sqrt(0.5f);
    expect_near(camera.right, {2, 0, 0});
    expect_near(camera.down, {0, -2 * h, 2 * h});
    expect_near(camera.top_left, {0, 1, 1 - 2 * h});
}

TEST_F(Cameras, have_the_window_that_the_file_says_whatever_the_picture_s_shape) {
    const Camera camera = this->camera("eye 0 0 5\ntarget 0 0 0\nwindow_size 2 2\nsize 64 48\n");
    expect_near(camera.right, {2, 0, 0});
    expect_near(camera.down, {0, -2, 0});
}

TEST_F(Cameras, measure_the_field_of_view_upright) {
    const Camera square = this->camera("eye 0 0 5\ntarget 0 0 0\nfov 90\n");
    expect_near(square.right, {2, 0, 0});
    expect_near(square.down, {0, -2, 0});
    // The size may come behind: a scene is what its whole file says.
    const Camera wide = this->camera("eye 0 0 5\ntarget 0 0 0\nfov 90\nsize 64 32\n");
    expect_near(wide.right, {4, 0, 0});
    expect_near(wide.down, {0, -2, 0});
    expect_near(wide.top_left, {-2, 1, 4});
    const Camera narrow = this->camera("size 30 60\nfov 60\neye 0 0 5\ntarget 0 0 0\n");
    expect_near(narrow.down, {0, -2 * std::tan(3.14159265f / 6), 0});
    expect_near(narrow.right, {std::tan(3.14159265f / 6), 0, 0});
}

TEST_F(Cameras, see_the_same_from_far_away) {
    // At this distance from the origin floats are 1/8 apart: a window at distance 1 would not even be square.
    const Camera camera = this->camera("eye 1000000 2000000 3000000\ntarget 1000000 2000000 0\n");
    const glm::vec3 to_corner = camera.top_left - camera.eye;
    EXPECT_NEAR(to_corner.x / to_corner.z, 1.0f, 1e-3f);
    EXPECT_NEAR(to_corner.y / to_corner.z, -1.0f, 1e-3f);
    EXPECT_NEAR(camera.right.x / to_corner.z, -2.0f, 1e-3f);
    EXPECT_NEAR(camera.down.y / to_corner.z, 2.0f, 1e-3f);
}

} // namespace
} // namespace glint::test
