// A scene while its file is being read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glint/read.hpp>

#include "sdl/mesh_library.hpp"
#include "text/problems.hpp"

namespace glint {

/// A value, and the place of the directive that gave it.
template <typename T> struct Given {
    T value;
    Place place;
};

/// The visible rectangle on the plane z = 0.
struct Window {
    float x0 = -1.0f, y0 = -1.0f, x1 = 1.0f, y1 = 1.0f;
};

/// What the directives so far have said. Handlers fill it; read_scene() checks what only the whole file shows.
struct SceneDraft {
    SceneDraft(const ReadOptions &options_, MeshLibrary &meshes_) : options(options_), meshes(meshes_) {}

    const ReadOptions &options;
    MeshLibrary &meshes;

    std::optional<Given<Point>> eye; ///< its place is that of z
    Given<Window> window{};
    PictureSettings picture;
    Color background{0.0f};
    float ambient = 0.0f;
    std::vector<Object> objects;
    std::vector<MeshLight> lights;
    uint64_t triangle_count = 0; ///< of all objects and lights
    std::optional<std::string> output_file;
};

} // namespace glint
