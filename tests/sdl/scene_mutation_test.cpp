// Broken in random ways, an SDL file gives a scene or an error, and never anything else.
#include <string>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/mutate.hpp"
#include "support/written_files.hpp"

namespace glint::test {
namespace {

constexpr std::string_view good = "# a room\neye 0.0 0.0 5.7\nsize 256 256\northo -1 -1 1 1\nbackground 0.0 0.0 0.0\n"
                                  "ambient 1\nmax_depth 1\noutput room.png\r\nlight lamp.obj 1.0 1.0 1.0 1.0\n"
                                  "object wall.obj 0.5 0.0 0.0 0.3 0.7 0.0 0.00 0.8 0.0\n"
                                  "object wall.obj 1.0 1.0 1.0 0.3 0.3 0.4 10.0 0.8 0.0 # again\n";

class MutatedScenes : public WrittenFiles {};

TEST_F(MutatedScenes, give_a_scene_or_an_error) {
    write("wall.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("lamp.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
    Random random(2005);
    int scenes = 0, errors = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::string text = mutated(good, random);
        const auto scene = read_scene(write("mutated.sdl", text));
        if (scene.ok()) {
            ++scenes;
            ASSERT_FALSE(scene->scene->objects().empty()) << text;
            continue;
        }
        ++errors;
        for (const Diagnostic &diagnostic : scene.error().diagnostics) {
            // What the scene builder finds, the reader missed: the builder knows no places.
            ASSERT_TRUE(diagnostic.line > 0 || diagnostic.message.starts_with("there is no '"))
                << text << diagnostic.text();
        }
    }
    EXPECT_GT(scenes, 200);
    EXPECT_GT(errors, 200);
}

} // namespace
} // namespace glint::test
