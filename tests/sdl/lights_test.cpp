// What each form of a light becomes.
#include <gtest/gtest.h>

#include "sdl/small_scene.hpp"

namespace glint::test {
namespace {

class Lights : public SmallScene {
protected:
    /// The light of a scene that has only this line, an eye and an object.
    [[nodiscard]] Light light(const std::string &line, const std::string &dialect = "glint",
                              const std::string &more = {}) const {
        const SceneFile file = read("dialect " + dialect + "\neye 0 0 5\n" + a_plane(dialect) + line + "\n" + more);
        EXPECT_EQ(file.scene->lights().size(), 1u);
        EXPECT_TRUE(file.warnings.empty()) << file.warnings.front().text();
        position_ = file.scene->light_positions()[0];
        return file.scene->lights()[0];
    }

    /// Where shadow rays to the last light aim.
    mutable Point position_{0.0f};
};

constexpr const char *everywhere[] = {"mobile2013", "path2005", "ray2005", "cg-path-tracer", "raycife", "glint"};

TEST_F(Lights, that_glow_are_meshes) {
    for (const char *dialect : everywhere) {
        const Light light = this->light("light lamp.obj .5 .25 2 3", dialect);
        EXPECT_EQ(light.kind, Light::Kind::surface);
        EXPECT_EQ(light.color, Color(0.5f, 0.25f, 2.0f));
        EXPECT_EQ(light.intensity, 3.0f);
        EXPECT_EQ(light.name, "lamp.obj");
        EXPECT_EQ(light.mesh->triangles.size(), 2u);
        EXPECT_FALSE(light.position);
        EXPECT_FALSE(light.has_falloff);
        EXPECT_EQ(position_, Point(0.5f, 0.5f, 1.0f));
    }
    EXPECT_EQ(light("lightarea lamp.obj .5 .25 2 3", "cg-path-tracer").color, Color(0.5f, 0.25f, 2.0f));
    EXPECT_EQ(light("lightarea lamp.obj .5 .25 2 3", "cg-path-tracer").mesh->triangles.size(), 2u);
}

TEST_F(Lights, of_raycife_say_where_shadow_rays_aim) {
    for (const char *dialect : {"raycife", "glint"}) {
        const Light light = this->light("light lamp.obj 1 .5 .25 3 0 3.75 -25", dialect, "nshadowrays 16\n");
        EXPECT_EQ(light.kind, Light::Kind::surface);
        EXPECT_EQ(light.color, Color(1, 0.5f, 0.25f));
        EXPECT_EQ(light.intensity, 3.0f);
        EXPECT_EQ(position_, Point(0, 3.75f, -25));
        EXPECT_EQ(light.shadow_rays, 1u) << "it has one place to come from";
    }
}

TEST_F(Lights, of_ray2005_are_white_points) {
    const Light light = this->light("light 1 -2 3 .5", "ray2005");
    EXPECT_EQ(light.kind, Light::Kind::point);
    EXPECT_EQ(light.position, Point(1, -2, 3));
    EXPECT_EQ(light.color, Color(1, 1, 1));
    EXPECT_EQ(light.intensity, 0.5f);
    EXPECT_FALSE(light.has_falloff);
    EXPECT_EQ(light.mesh, nullptr);
}

TEST_F(Lights, may_be_points_of_any_colour) {
    const auto expect = [&](const std::string &line, const std::string &dialect, bool falloff) {
        const Light light = this->light(line, dialect);
        EXPECT_EQ(light.kind, Light::Kind::point);
        EXPECT_EQ(light.position, Point(1, -2, 3));
        EXPECT_EQ(position_, Point(1, -2, 3));
        EXPECT_EQ(light.color, Color(0.5f, 0.25f, 2.0f));
        EXPECT_EQ(light.intensity, 4.0f);
        EXPECT_EQ(light.has_falloff, falloff);
    };
    expect("lightpoint 1 -2 3 .5 .25 2 4", "cg-path-tracer", false);
    for (const char *dialect : everywhere) {
        expect("light_point 1 -2 3 .5 .25 2 4", dialect, false);
        expect("light_point 1 -2 3 .5 .25 2 4 falloff off", dialect, false);
        expect("light_point 1 -2 3 .5 .25 2 4 falloff on", dialect, true);
    }
}

TEST_F(Lights, may_come_from_infinitely_far) {
    for (const char *dialect : everywhere) {
        const Light light = this->light("light_directional 0 -2 .5 .5 .25 2 4", dialect);
        EXPECT_EQ(light.kind, Light::Kind::directional);
        EXPECT_EQ(light.direction, Vector(0, -2, 0.5f));
        EXPECT_EQ(light.color, Color(0.5f, 0.25f, 2.0f));
        EXPECT_EQ(light.intensity, 4.0f);
        EXPECT_FALSE(light.position);
    }
}

TEST_F(Lights, may_shine_into_a_cone) {
    for (const char *dialect : everywhere) {
        const Light light = this->light("light_spot 1 2 3 0 -1 .5 30 45 .5 .25 2 4", dialect);
        EXPECT_EQ(light.kind, Light::Kind::spot);
        EXPECT_EQ(light.position, Point(1, 2, 3));
        EXPECT_EQ(light.direction, Vector(0, -1, 0.5f));
        EXPECT_FLOAT_EQ(light.inner_angle, 0.52359878f);
        EXPECT_FLOAT_EQ(light.outer_angle, 0.78539816f);
        EXPECT_EQ(light.color, Color(0.5f, 0.25f, 2.0f));
        EXPECT_EQ(light.intensity, 4.0f);
        EXPECT_FALSE(light.has_falloff);
        EXPECT_TRUE(this->light("light_spot 1 2 3 0 -1 .5 30 45 .5 .25 2 4 falloff on", dialect).has_falloff);
    }
}

TEST_F(Lights, may_shine_into_cones_of_every_width) {
    for (int outer = 0; outer <= 180; ++outer) {
        for (const int inner : {0, outer / 2, outer}) {
            const Light light = this->light("light_spot 0 1 0 0 -1 0 " + std::to_string(inner) + ' ' +
                                            std::to_string(outer) + " 1 1 1 1");
            EXPECT_EQ(inner == outer, light.inner_angle == light.outer_angle) << inner << ' ' << outer;
        }
    }
}

TEST_F(Lights, may_be_ellipsoids) {
    for (const char *dialect : everywhere) {
        // A sphere of radius 0.5 around (1, 2, 3), in the words of ray2005 whatever the dialect.
        const Light light = this->light("light_quadric 1 1 1 0 0 0 -1 -2 -3 13.75 .5 .25 2 4", dialect);
        EXPECT_EQ(light.kind, Light::Kind::surface);
        EXPECT_EQ(light.quadric, (Quadric{1, 1, 1, 0, 0, 0, -1, -2, -3, 13.75f}));
        EXPECT_EQ(light.mesh, nullptr);
        EXPECT_EQ(light.color, Color(0.5f, 0.25f, 2.0f));
        EXPECT_EQ(light.intensity, 4.0f);
        EXPECT_EQ(position_, Point(1, 2, 3));
    }
}

TEST_F(Lights, may_be_many_of_all_kinds) {
    const auto scene = with("light_point 0 0 0 1 1 1 1\nlight lamp.obj 1 1 1 1 0 1 0\nlight_directional 0 1 0 1 1 1 1\n"
                            "light_quadric 1 1 1 0 0 0 0 0 0 -1 1 1 1 1\n")
                           .scene;
    ASSERT_EQ(scene->lights().size(), 5u);
    EXPECT_EQ(scene->surface_count(), 6u);
    EXPECT_EQ(scene->triangle_count(), 4u);
    EXPECT_EQ(scene->quadric_surfaces(), (std::vector<uint32_t>{0, 5})) << "the object is one, too";
}

} // namespace
} // namespace glint::test
