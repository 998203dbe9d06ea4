// cornell.sdl is the 2013 paper's scene: its numbers, over a room of its dimensions.
#include <memory>
#include <tuple>

#include <glint/read.hpp>
#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "scenes/scene_folder.hpp"

namespace glint::test {
namespace {

struct Bounds {
    Point low{1e30f};
    Point high{-1e30f};
};

Bounds bounds_of(const Mesh &mesh) {
    Bounds bounds;
    for (const Point p : mesh.positions) {
        bounds.low = glm::min(bounds.low, p);
        bounds.high = glm::max(bounds.high, p);
    }
    return bounds;
}

class PaperRoom : public testing::Test {
protected:
    void SetUp() override {
        auto file = read_scene(scene_folder() / "cornell.sdl");
        ASSERT_TRUE(file.ok()) << file.error().text();
        scene = file->scene;
        ASSERT_EQ(scene->objects().size(), 7u);
        ASSERT_EQ(scene->lights().size(), 1u);
    }
    [[nodiscard]] Bounds object_bounds(size_t object) const { return bounds_of(*scene->objects()[object].mesh); }

    std::shared_ptr<const Scene> scene;
};

enum PaperObject : size_t { left_wall, right_wall, back, floor_, ceiling, short_block, tall_block };

TEST_F(PaperRoom, has_the_papers_camera_and_settings) {
    EXPECT_EQ(scene->camera().eye, Point(0.0f, 0.0f, 5.7f));
    EXPECT_EQ(scene->camera().top_left, Point(-1.0f, 1.0f, 0.0f));
    EXPECT_EQ(scene->picture().width_px, 256u);
    EXPECT_EQ(scene->picture().height_px, 256u);
    EXPECT_EQ(scene->ambient(), 1.0f);
    EXPECT_EQ(scene->background(), Color(0.0f));
}

TEST_F(PaperRoom, has_the_papers_materials) {
    const auto &objects = scene->objects();
    for (const size_t mirror : {left_wall, right_wall, back}) EXPECT_EQ(objects[mirror].material.reflection, 0.8f);
    for (const size_t dull : {floor_, ceiling, short_block, tall_block})
        EXPECT_EQ(objects[dull].material.reflection, 0.0f);
    EXPECT_EQ(objects[left_wall].material.color, Color(0.5f, 0.0f, 0.0f));
    EXPECT_EQ(objects[right_wall].material.color, Color(0.0f, 0.5f, 0.0f));
    EXPECT_EQ(objects[back].material.specular, 0.4f);
    EXPECT_EQ(objects[back].material.specular_exponent, 10.0f);
    EXPECT_EQ(objects[short_block].material.color, Color(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(objects[tall_block].material.color, Color(0.0f, 1.0f, 0.0f));
}

TEST_F(PaperRoom, has_the_public_dimensions) {
    const Point low{-3.822f, -3.8416f, -32.76f};
    const Point high{3.822f, 3.8416f, -16.59f};
    EXPECT_EQ(object_bounds(left_wall).low, low);
    EXPECT_EQ(object_bounds(left_wall).high, Point(low.x, high.y, high.z));
    EXPECT_EQ(object_bounds(right_wall).low, Point(high.x, low.y, low.z));
    EXPECT_EQ(object_bounds(right_wall).high, high);
    EXPECT_EQ(object_bounds(back).high, Point(high.x, high.y, low.z));
    EXPECT_EQ(object_bounds(floor_).high, Point(high.x, low.y, high.z));
    EXPECT_EQ(object_bounds(ceiling).low, Point(low.x, high.y, low.z));
    const Bounds lamp = bounds_of(*scene->lights().front().mesh);
    EXPECT_EQ(lamp.low, Point(-0.91f, 3.836f, -26.488f));
    EXPECT_EQ(lamp.high, Point(0.91f, 3.836f, -23.324f));
}

TEST_F(PaperRoom, has_two_blocks_that_stand_on_its_floor) {
    for (const auto &[block, top, nearest_z, farthest_z] :
         {std::tuple{short_block, -1.53f, -19.0f, -26.0f}, {tall_block, 0.8f, -24.0f, -31.0f}}) {
        const Bounds bounds = object_bounds(block);
        EXPECT_EQ(bounds.low.y, -3.8416f);
        EXPECT_EQ(bounds.high.y, top);
        EXPECT_LE(bounds.high.z, nearest_z);
        EXPECT_GE(bounds.low.z, farthest_z);
        EXPECT_GT(bounds.low.x, -3.822f);
        EXPECT_LT(bounds.high.x, 3.822f);
    }
}

} // namespace
} // namespace glint::test
