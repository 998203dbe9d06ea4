// What there is to see: meshes, materials, lights and a camera; immutable once built.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include <glint/export.hpp>
#include <glint/result.hpp>

namespace glint {

using Point = glm::vec3;  ///< a place, in the scene's own units; right-handed world
using Vector = glm::vec3; ///< a direction or displacement
using Color = glm::vec3;  ///< linear red, green, blue; 1 is the brightest a display shows

/// Three indices into a mesh's positions; counter-clockwise or clockwise makes no difference to the shading.
struct Triangle {
    uint32_t a = 0, b = 0, c = 0;
    friend bool operator==(const Triangle &, const Triangle &) = default;
};

/// A triangle mesh. Several objects, lights and scenes may share one.
struct Mesh {
    std::vector<Point> positions;
    std::vector<Triangle> triangles;
};

/// How a surface answers light: the nine numbers of the 2013 dialect. Fractions are in [0, 1].
/// Source: the Whitted model with Phong highlights (Whitted 1980; Phong 1975).
struct Material {
    Color color{1.0f};              ///< surface colour C, each channel in [0, 1]
    float ambient = 0.0f;           ///< ka
    float diffuse = 1.0f;           ///< kd
    float specular = 0.0f;          ///< ks
    float specular_exponent = 0.0f; ///< ke >= 0
    float reflection = 0.0f;        ///< kr: share of the colour that comes along the mirror ray
    float transmission = 0.0f;      ///< kt: share that comes straight through; kr + kt <= 1
};

/// Something that is lit: a mesh and its material.
struct Object {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    Material material;
};

/// A glowing mesh. Whitted shading aims one shadow ray at its area-weighted centroid; seen directly it shows
/// color * intensity. Its own mesh never blocks its own shadow rays. No fall-off with distance.
struct MeshLight {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    Color color{1.0f};
    float intensity = 1.0f;
};

/// A pinhole: rays leave `eye` through a rectangle in space (the window). The picture's pixels divide the window
/// evenly, row 0 along its top edge; a pixel's ray goes through the pixel's centre.
struct GLINT_API Camera {
    Point eye{0.0f, 0.0f, 5.7f};
    Point top_left{-1.0f, 1.0f, 0.0f}; ///< the window's top left corner
    Vector right{2.0f, 0.0f, 0.0f};    ///< from the top left corner to the top right one
    Vector down{0.0f, -2.0f, 0.0f};    ///< from the top left corner to the bottom left one

    /// The SDL family's camera: `ortho x0 y0 x1 y1` is the visible rectangle on the plane z = 0, from its lower left to
    /// its upper right corner.
    [[nodiscard]] static Camera through_window(Point eye, float x0, float y0, float x1, float y1);
};

/// How the scene's author wants it rendered; a program may choose otherwise.
struct PictureSettings {
    uint32_t width_px = 256;
    uint32_t height_px = 256;
    uint32_t max_depth = 1; ///< at most this many recursive rays in a row after the primary ray
};

/// Which kind of surface a triangle belongs to, and which one in the scene's list of that kind.
struct SurfaceRef {
    bool is_light = false;
    uint32_t index = 0; ///< into objects() or lights()
};

/// A complete, valid scene. Nothing in it can change, so any number of threads and renderers may share it.
///
/// Triangles are numbered through the scene: all objects' triangles in the order the objects were added, then all
/// lights' triangles likewise. These numbers are the `triangle_id` that the acceleration structure reports.
class GLINT_API Scene {
public:
    [[nodiscard]] const std::vector<Object> &objects() const { return objects_; }
    [[nodiscard]] const std::vector<MeshLight> &lights() const { return lights_; }
    [[nodiscard]] const Camera &camera() const { return camera_; }
    [[nodiscard]] const PictureSettings &picture() const { return picture_; }
    [[nodiscard]] Color background() const { return background_; }
    [[nodiscard]] float ambient() const { return ambient_; }

    /// Triangles of all objects and lights together; at most 2^30.
    [[nodiscard]] uint32_t triangle_count() const { return triangle_count_; }
    /// Surfaces in triangle order: every object, then every light.
    [[nodiscard]] uint32_t surface_count() const { return static_cast<uint32_t>(objects_.size() + lights_.size()); }
    /// The mesh of surface s, s < surface_count().
    [[nodiscard]] const Mesh &surface_mesh(uint32_t s) const;
    /// Whether surface s is an object or a light, and which.
    [[nodiscard]] SurfaceRef surface(uint32_t s) const;
    /// Where shadow rays to each light aim: the area-weighted centroid of its mesh, in the order of lights().
    [[nodiscard]] const std::vector<Point> &light_centroids() const { return light_centroids_; }
    /// Triangles that had no area and were left out when the scene was built.
    [[nodiscard]] uint32_t skipped_triangles() const { return skipped_triangles_; }

private:
    friend class SceneBuilder;
    Scene() = default;

    std::vector<Object> objects_;
    std::vector<MeshLight> lights_;
    std::vector<Point> light_centroids_;
    Camera camera_;
    PictureSettings picture_;
    Color background_{0.0f};
    float ambient_ = 0.0f;
    uint32_t triangle_count_ = 0;
    uint32_t skipped_triangles_ = 0;
};

/// Coordinates and lengths are at most this large, so that no product inside the tracer overflows a float.
inline constexpr float max_coordinate = 1e12f;
/// Intensities, backgrounds and exponents are at most this large.
inline constexpr float max_intensity = 1e6f;

/// Largest values a scene may ask for; a caller that wants more raises them.
struct SceneLimits {
    uint64_t max_pixels = uint64_t{1} << 26;    ///< width * height (8192 x 8192)
    uint32_t max_depth = 1000;                  ///< recursive rays in a row
    uint64_t max_triangles = uint64_t{1} << 27; ///< in the whole scene
};

/// Collects the parts of a scene, then checks them once. Readers and programs make scenes through this class only.
///
///     SceneBuilder builder;
///     builder.add_object({"floor", mesh, material});
///     builder.add_light({"lamp", lamp_mesh, {1, 1, 1}, 1.0f});
///     Result<std::shared_ptr<const Scene>> scene = builder.build();
class GLINT_API SceneBuilder {
public:
    explicit SceneBuilder(SceneLimits limits = {}) : limits_(limits) {}

    SceneBuilder &add_object(Object object);
    SceneBuilder &add_light(MeshLight light);
    SceneBuilder &set_camera(const Camera &camera);
    SceneBuilder &set_picture(const PictureSettings &picture);
    SceneBuilder &set_background(Color background);
    SceneBuilder &set_ambient(float ambient);

    /// Checks everything and hands the scene over; the builder is empty afterwards.
    /// Fails, with one diagnostic for each problem, when there is no object, a mesh is missing or empty, an index is
    /// out of range, a number is not finite, a fraction is outside [0, 1], kr + kt > 1, the camera's window has no area
    /// or contains the eye's plane, or a limit is passed. Triangles without area are left out and counted; a mesh that
    /// has no other triangles is an error. A scene without lights is allowed here (readers may be stricter).
    [[nodiscard]] Result<std::shared_ptr<const Scene>> build();

private:
    SceneLimits limits_;
    std::vector<Object> objects_;
    std::vector<MeshLight> lights_;
    Camera camera_;
    PictureSettings picture_;
    Color background_{0.0f};
    float ambient_ = 0.0f;
};

} // namespace glint
