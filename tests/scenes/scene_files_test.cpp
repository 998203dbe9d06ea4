// Every scene of scenes/sdl reads without a warning and holds what its folder's README says of it.
#include <algorithm>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <glint/read.hpp>
#include <gtest/gtest.h>

#include "scenes/scene_folder.hpp"

namespace glint::test {
namespace {

struct Promise {
    std::string file;
    uint32_t at_least_triangles;
    size_t lights;
    uint32_t max_depth;
    std::string dialect = "mobile2013"; ///< whose scenes are square, and lit no more than there is light
    friend void PrintTo(const Promise &promise, std::ostream *out) { *out << promise.file; }
};

const std::vector<Promise> promises{{"cornell.sdl", 32, 1, 1},
                                    {"mirrors.sdl", 10'000, 2, 10},
                                    {"sphereflake.sdl", 1'000'000, 2, 3},
                                    {"terrain.sdl", 1'000'000, 1, 2},
                                    {"gears.sdl", 50'000, 2, 3},
                                    {"lights16.sdl", 10'000, 16, 2},
                                    {"glass.sdl", 0, 2, 8, "glint"},
                                    {"carousel.sdl", 100'000, 2, 2, "glint"}};

/// The cells of the README's row about a scene, without blanks; empty where there is none.
std::vector<std::string> readme_row(const std::string &scene) {
    std::istringstream readme(text_of(scene_folder() / "README.md"));
    for (std::string line; std::getline(readme, line);) {
        if (!line.starts_with("| [" + scene + "]")) continue;
        std::vector<std::string> cells;
        std::istringstream row(line.substr(1));
        for (std::string cell; std::getline(row, cell, '|');) {
            std::erase_if(cell, [](char c) { return c == ' ' || c == ','; });
            cells.push_back(cell);
        }
        return cells;
    }
    return {};
}

class SceneFileOfOurs : public testing::TestWithParam<Promise> {};

TEST_P(SceneFileOfOurs, holds_what_is_promised_of_it) {
    const Promise &promise = GetParam();
    const auto file = read_scene(scene_folder() / promise.file);
    ASSERT_TRUE(file.ok()) << file.error().text();
    EXPECT_TRUE(file->warnings.empty()) << file->warnings.front().text();
    EXPECT_EQ(file->dialect, promise.dialect);

    const Scene &scene = *file->scene;
    EXPECT_GE(scene.triangle_count(), promise.at_least_triangles);
    EXPECT_EQ(scene.skipped_triangles(), 0u);
    EXPECT_EQ(scene.lights().size(), promise.lights);
    EXPECT_EQ(scene.picture().max_depth, promise.max_depth);

    const auto row = readme_row(promise.file);
    ASSERT_GE(row.size(), 4u) << "the README has no row about it";
    EXPECT_EQ(row[1], std::to_string(scene.triangle_count()));
    EXPECT_EQ(row[2], std::to_string(promise.lights));
    EXPECT_EQ(row[3], std::to_string(promise.max_depth));

    if (promise.dialect != "mobile2013") return;
    // Square, as the sizes that are measured are.
    EXPECT_FLOAT_EQ(scene.camera().right.x, -scene.camera().down.y);
    EXPECT_EQ(scene.picture().width_px, scene.picture().height_px);
    for (const Object &object : scene.objects()) {
        const Material &m = object.material;
        EXPECT_NEAR(m.ambient + m.diffuse + m.specular, 1.0f, 1e-6f) << object.name;
    }
}

TEST_P(SceneFileOfOurs, begins_with_a_line_that_says_what_it_shows) {
    const std::string text = text_of(scene_folder() / GetParam().file);
    EXPECT_TRUE(text.starts_with("# ")) << text.substr(0, 80);
}

INSTANTIATE_TEST_SUITE_P(, SceneFileOfOurs, testing::ValuesIn(promises), [](const auto &instance) {
    return instance.param.file.substr(0, instance.param.file.find('.'));
});

TEST(SceneFolder, has_no_scene_that_nobody_tests) {
    for (const auto &entry : std::filesystem::directory_iterator(scene_folder())) {
        if (entry.path().extension() != ".sdl") continue;
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(std::any_of(promises.begin(), promises.end(), [&](const auto &p) { return p.file == name; }))
            << name;
    }
}

} // namespace
} // namespace glint::test
