// The ray trees of our own scenes add up to the pixels of the golden pictures.
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "golden/golden_table.hpp"
#include "support/ray_tree_checks.hpp"

namespace glint::test {
namespace {

const std::filesystem::path source = GLINT_SOURCE_DIR;

std::vector<Golden> pictures() {
    return golden_table(source / "tests" / "golden" / "pictures.txt");
}

std::set<std::string> scenes() {
    std::set<std::string> names;
    for (const Golden &golden : pictures()) names.insert(golden.scene);
    return names;
}

class TreesOfScene : public testing::TestWithParam<std::string> {};

TEST_P(TreesOfScene, add_up_to_the_pixels) {
    const auto file = read_scene(source / "scenes" / "sdl" / (GetParam() + ".sdl"));
    ASSERT_TRUE(file.ok()) << file.error().text();
    const auto accel = Accel::build(file->scene);
    Renderer renderer(accel);
    for (const Golden &golden : pictures()) {
        if (golden.scene != GetParam()) continue;
        SCOPED_TRACE(golden);
        RenderOptions options;
        options.max_depth = golden.depth;
        check_pixels(accel, picture_of(renderer, options, golden.width, golden.height), options, 200);
        options.samples_per_pixel = 5;
        options.pattern = SamplePattern::jittered;
        options.transfer = Transfer::srgb;
        check_pixels(accel, picture_of(renderer, options, golden.width, golden.height), options, 50);
    }
}

INSTANTIATE_TEST_SUITE_P(, TreesOfScene, testing::ValuesIn(scenes()), [](const auto &scene) { return scene.param; });

} // namespace
} // namespace glint::test
