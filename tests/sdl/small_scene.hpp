// Scenes of a few lines, beside two small meshes, for tests of what directives do.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include <glint/read.hpp>

#include "support/written_files.hpp"

namespace glint::test {

/// A folder with wall.obj (one triangle, with the origin for its first corner) and lamp.obj (two).
class SmallScene : public WrittenFiles {
protected:
    void SetUp() override {
        WrittenFiles::SetUp();
        write("wall.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("lamp.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\nf 1 2 3\nf 2 3 4\n");
    }

    /// What the text becomes; throws its problems.
    [[nodiscard]] SceneFile read(std::string_view text, const ReadOptions &options = {}) const {
        auto scene = read_scene(write("scene.sdl", text), options);
        if (!scene.ok()) throw std::runtime_error(scene.error().text());
        return std::move(scene).value();
    }
    /// The same of a scene in the dialect that gets an eye, a light and an object besides `lines`.
    [[nodiscard]] SceneFile with(const std::string &lines, const std::string &dialect = "glint") const {
        return read("dialect " + dialect + "\neye 0 0 5\nlight lamp.obj 1 1 1 1\n" + a_plane(dialect) + lines);
    }
    /// Why the text is refused.
    [[nodiscard]] Error error_of(std::string_view text, const ReadOptions &options = {}) const {
        const auto scene = read_scene(write("scene.sdl", text), options);
        if (scene.ok()) throw std::runtime_error("was read:\n" + std::string(text));
        return scene.error();
    }

    /// An object in the dialect's own words.
    [[nodiscard]] static std::string a_plane(const std::string &dialect) {
        if (dialect == "mobile2013") return "object wall.obj 1 1 1 0 1 0 0 0 0\n";
        if (dialect == "path2005" || dialect == "raycife") return "object wall.obj 1 1 1 0 1 0 0 5\n";
        return "objectquadric 0 0 0 0 0 0 0 1 0 1 1 1 1 0 1 0 0 0 0 1\n";
    }
};

} // namespace glint::test
