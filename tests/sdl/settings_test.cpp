// What the directives for the picture, the optics and the shadows set, in every dialect.
#include <gtest/gtest.h>

#include "sdl/dialects.hpp"
#include "sdl/small_scene.hpp"

namespace glint::test {
namespace {

class Settings : public SmallScene, public ::testing::WithParamInterface<Dialect> {
protected:
    [[nodiscard]] SceneFile with(const std::string &lines) const {
        return SmallScene::with(lines, std::string(dialect_name(GetParam())));
    }
    [[nodiscard]] PictureSettings picture(const std::string &lines) const { return with(lines).scene->picture(); }
};

TEST_P(Settings, have_defaults) {
    const PictureSettings picture = this->picture("");
    EXPECT_EQ(picture.width_px, 256u);
    EXPECT_EQ(picture.height_px, 256u);
    EXPECT_EQ(picture.max_depth, 1u);
    EXPECT_EQ(picture.samples_per_pixel, 1u);
    EXPECT_EQ(picture.pattern, SamplePattern::centre);
    EXPECT_EQ(picture.seed, 0u);
    EXPECT_EQ(picture.tone_scale, 0.0f);
    EXPECT_EQ(picture.paths_per_pixel, 1u);
    EXPECT_FALSE(with("").scene->optics().fresnel);
    EXPECT_FALSE(with("").scene->optics().shadows_through_glass);
}

TEST_P(Settings, of_the_picture_are_kept) {
    const SceneFile file = with("size 64 48\nbackground .25 .5 4\nambient .75\noutput room.png\n");
    EXPECT_EQ(file.scene->picture().width_px, 64u);
    EXPECT_EQ(file.scene->picture().height_px, 48u);
    EXPECT_EQ(file.scene->background(), Color(0.25f, 0.5f, 4.0f));
    EXPECT_EQ(file.scene->ambient(), 0.75f);
    EXPECT_EQ(file.output_file, "room.png");
}

TEST_P(Settings, call_the_depth_by_any_of_its_four_names) {
    for (const char *name : {"max_depth", "maxdepth", "profundidade", "reflections"}) {
        EXPECT_EQ(picture(std::string(name) + " 7\n").max_depth, 7u) << name;
    }
}

TEST_P(Settings, of_the_samples_come_in_two_forms) {
    EXPECT_EQ(picture("supersample on\n").samples_per_pixel, 4u);
    EXPECT_EQ(picture("supersample ON\n").samples_per_pixel, 4u);
    EXPECT_EQ(picture("supersample on\n").pattern, SamplePattern::centre);
    EXPECT_EQ(picture("supersample off\n").samples_per_pixel, 1u);
    EXPECT_EQ(picture("samples 9\n").samples_per_pixel, 9u);
    EXPECT_EQ(picture("samples 9\n").pattern, SamplePattern::centre);
    EXPECT_EQ(picture("samples 16 centre\n").pattern, SamplePattern::centre);
    EXPECT_EQ(picture("samples 16 stratified\n").pattern, SamplePattern::stratified);
    EXPECT_EQ(picture("samples 4096 jittered\n").pattern, SamplePattern::jittered);
    EXPECT_EQ(picture("samples 4096 jittered\n").samples_per_pixel, 4096u);
}

TEST_P(Settings, that_a_path_tracer_wants_are_kept) {
    const SceneFile file = with("npaths 50\ntonemapping 1.5\nseed 4294967295\n");
    EXPECT_EQ(file.scene->picture().paths_per_pixel, 50u);
    EXPECT_EQ(file.scene->picture().tone_scale, 1.5f);
    EXPECT_EQ(file.scene->picture().seed, 4294967295u);
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(file.warnings[0].message,
              "'npaths' asks for a path tracer; Glint's rays are Whitted's, and it has no effect");
    EXPECT_TRUE(with("npaths 1\n").warnings.empty());
    EXPECT_TRUE(with("npaths 0\n").warnings.empty());
}

TEST_P(Settings, of_the_optics_are_kept) {
    EXPECT_TRUE(with("fresnel on\n").scene->optics().fresnel);
    EXPECT_FALSE(with("fresnel off\n").scene->optics().fresnel);
    EXPECT_TRUE(with("shadows_through_glass on\n").scene->optics().shadows_through_glass);
    EXPECT_FALSE(with("shadows_through_glass off\n").scene->optics().shadows_through_glass);
}

TEST_P(Settings, say_whether_reflections_add_and_else_the_dialect_does) {
    EXPECT_EQ(with("").scene->objects()[0].material.adds_to_local, adds_reflections(GetParam()));
    EXPECT_TRUE(with("reflection_adds on\n").scene->objects()[0].material.adds_to_local);
    EXPECT_FALSE(with("reflection_adds off\n").scene->objects()[0].material.adds_to_local);
}

TEST_P(Settings, of_the_shadow_rays_stand_for_every_mesh_light) {
    EXPECT_EQ(with("").scene->lights()[0].shadow_rays, 1u);
    const auto rays = with("light lamp.obj 1 1 1 2\nnshadowrays 16\n").scene->lights();
    EXPECT_EQ(rays[0].shadow_rays, 16u);
    EXPECT_EQ(rays[1].shadow_rays, 16u);
    EXPECT_EQ(with("nshadowrays 0\n").scene->lights()[0].shadow_rays, 1u) << "files with point lights say so";
    const auto grid = with("lightresolution 4 3\n").scene->lights();
    EXPECT_EQ(grid[0].grid_width, 4u);
    EXPECT_EQ(grid[0].grid_height, 3u);
    EXPECT_EQ(with("light_point 0 1 0 1 1 1 1\nnshadowrays 16\n").scene->lights()[1].shadow_rays, 1u)
        << "a point has one place";
}

INSTANTIATE_TEST_SUITE_P(In, Settings,
                         ::testing::Values(Dialect::mobile2013, Dialect::path2005, Dialect::ray2005,
                                           Dialect::cg_path_tracer, Dialect::raycife, Dialect::glint),
                         [](const auto &test) {
                             std::string name(dialect_name(test.param));
                             for (char &c : name) c = c == '-' ? '_' : c;
                             return name;
                         });

} // namespace
} // namespace glint::test
