// A scene while its file is being read: what its directives have said.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glint/read.hpp>

#include "sdl/mesh_library.hpp"
#include "sdl/motion_draft.hpp"
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

/// A rectangle seen by a look-at camera at distance 1.
struct WindowSize {
    float width = 2.0f, height = 2.0f;
};

/// An `object` line. Those that take their materials from an MTL file are as many objects as materials.
struct ObjectDraft {
    std::vector<Object> parts;
    std::filesystem::path file; ///< of the mesh, as it was found; empty for a quadric
    Vector offset{0.0f};
    bool from_mtl = false;
};

/// A line that adds a light.
struct LightDraft {
    Light light;
    std::filesystem::path file;                       ///< of the mesh, as it was found; empty for other lights
    float inner_degrees = 0.0f, outer_degrees = 0.0f; ///< of a spot light, as written
};

/// What the directives so far have said. Handlers fill it; DraftReader checks what only the whole file shows.
struct SceneDraft {
    SceneDraft(const ReadOptions &options_, MeshLibrary &meshes_) : options(options_), meshes(meshes_) {}

    const ReadOptions &options;
    MeshLibrary &meshes;

    std::optional<Given<Point>> eye; ///< its place is that of z
    std::optional<Given<Point>> target;
    std::optional<Given<Vector>> up;
    std::optional<Given<Window>> ortho;
    std::optional<Given<WindowSize>> window_size;
    std::optional<Given<float>> fov; ///< degrees
    PictureSettings picture;
    bool has_samples = false; ///< whether a directive has set the picture's samples a pixel
    Color background{0.0f};
    float ambient = 0.0f;
    OpticsSettings optics;
    std::optional<bool> reflection_adds; ///< unset: as the dialect has it; set once the whole file was read
    uint32_t shadow_rays = 1;            ///< of every mesh light
    uint32_t grid_width = 0, grid_height = 0;
    std::vector<ObjectDraft> objects;
    std::vector<LightDraft> lights;
    MotionDraft motion;
    uint64_t triangle_count = 0; ///< of all objects and lights
    std::optional<std::string> output_file;
};

} // namespace glint
