// SDL files of a size that would show a quadratic reader or a wasteful one.
#include <string>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/cpu_time.hpp"
#include "support/written_files.hpp"

namespace glint::test {
namespace {

class LargeScenes : public WrittenFiles {
protected:
    void SetUp() override {
        WrittenFiles::SetUp();
        write("wall.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    /// Reads the text and fails the test where that takes far longer than it ever should.
    [[nodiscard]] Result<SceneFile> read(std::string_view text) const {
        const auto file = write("large.sdl", text);
        const CpuTime time;
        auto scene = read_scene(file);
        EXPECT_LT(time.seconds(), 60.0);
        return scene;
    }
};

constexpr std::string_view start = "eye 0 0 5\nmax_depth 1\nlight wall.obj 1 1 1 1\n";
constexpr std::string_view object = "object wall.obj 1 1 1 0 1 0 0 0 0\n";

TEST_F(LargeScenes, may_have_very_many_objects) {
    constexpr size_t many = 300'000;
    std::string text(start);
    for (size_t i = 0; i < many; ++i) text += object;
    const auto scene = read(text);
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    EXPECT_EQ(scene->scene->objects().size(), many);
    EXPECT_EQ(scene->mesh_files.size(), 1u);
}

TEST_F(LargeScenes, may_have_a_million_wrong_directives) {
    std::string text(start);
    for (int i = 0; i < 1'000'000; ++i) text += "objekt 1\n";
    const auto scene = read(text + std::string(object));
    ASSERT_FALSE(scene.ok());
    ASSERT_EQ(scene.error().diagnostics.size(), 101u);
    EXPECT_EQ(scene.error().diagnostics[100].message, "and 999900 more problems");
}

TEST_F(LargeScenes, may_have_endless_lines) {
    const std::string good = std::string(start) + std::string(object);
    EXPECT_TRUE(read(good + '#' + std::string(10'000'000, '#')).ok());
    EXPECT_TRUE(read(std::string(10'000'000, ' ') + good).ok());
    std::string arguments = "size";
    for (int i = 0; i < 5'000'000; ++i) arguments += " 1";
    for (const std::string &bad : {std::string(10'000'000, 'x'), "ambient " + std::string(10'000'000, '7'),
                                   std::string(10'000'000, ' ') + "x", arguments}) {
        const auto scene = read(good + bad);
        ASSERT_FALSE(scene.ok());
        EXPECT_LT(scene.error().text().size(), 1000u);
    }
}

} // namespace
} // namespace glint::test
