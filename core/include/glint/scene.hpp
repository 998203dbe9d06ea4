// What there is to see: meshes, materials, lights and a camera; immutable once built.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <glint/export.hpp>
#include <glint/result.hpp>
#include <glint/rigid_transform.hpp>

namespace glint {

using Point = glm::vec3;  ///< a place, in the scene's own units; right-handed world
using Vector = glm::vec3; ///< a direction or displacement
using Color = glm::vec3;  ///< linear red, green, blue; 1 is the brightest a display shows

/// Three indices into a mesh's positions; counter-clockwise or clockwise makes no difference to the shading.
struct Triangle {
    uint32_t a = 0, b = 0, c = 0;
    friend bool operator==(const Triangle &, const Triangle &) = default;
};

/// The corner of a triangle that has no normal or texture coordinate.
inline constexpr uint32_t no_corner = UINT32_MAX;

/// A triangle mesh. Several objects, lights and scenes may share one.
struct Mesh {
    std::vector<Point> positions;
    std::vector<Triangle> triangles;

    /// Normals that shading interpolates instead of the triangles' own; not zero, any length. normal_corners says which
    /// of them each triangle has at its corners; a triangle with no_corner for its `a` is flat. Both may be empty.
    std::vector<Vector> normals = {};
    std::vector<Triangle> normal_corners = {};

    /// Where the corners lie in a texture: u from left to right, v from bottom to top, each repeating from 1 on.
    /// texcoord_corners works as normal_corners does; a triangle without shows the texture's place (0, 0).
    std::vector<glm::vec2> texcoords = {};
    std::vector<Triangle> texcoord_corners = {};
};

/// The points where a x^2 + b y^2 + c z^2 + 2 d xy + 2 e yz + 2 f xz + 2 g x + 2 h y + 2 j z + k = 0: a sphere, an
/// ellipsoid, a cylinder, a cone, a paraboloid, a hyperboloid, a plane or a pair of planes. Its inside, for refraction,
/// is where the sum is negative, as it is inside an ellipsoid or cylinder whose first coefficients are positive.
struct Quadric {
    float a = 0.0f, b = 0.0f, c = 0.0f, d = 0.0f, e = 0.0f, f = 0.0f, g = 0.0f, h = 0.0f, j = 0.0f, k = 0.0f;
    friend bool operator==(const Quadric &, const Quadric &) = default;
};

/// A picture that colours a surface; texels are looked up with bilinear interpolation and repeat in both directions.
struct Texture {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    std::vector<Color> texels; ///< width_px * height_px of them, the top row first; each channel in [0, 1]
};

/// How a surface answers light: the Whitted model with Phong highlights (Whitted 1980; Phong 1975). Fractions are in
/// [0, 1].
struct Material {
    Color color{1.0f};              ///< surface colour C, each channel in [0, 1]
    float ambient = 0.0f;           ///< ka
    float diffuse = 1.0f;           ///< kd
    float specular = 0.0f;          ///< ks
    float specular_exponent = 0.0f; ///< ke >= 0
    float reflection = 0.0f;        ///< kr: share of the colour that comes along the mirror ray
    float transmission = 0.0f;      ///< kt: share that comes through the surface; kr + kt <= 1
    float ior = 1.0f;               ///< index of refraction of what the surface encloses; 1 lets rays go straight on
    Color highlight_color{1.0f};    ///< of the highlight, besides the light's, each channel in [0, 1]
    /// Whether mirrored and transmitted light is added to the local colour, as Whitted had it and the dialects of 2005
    /// have, or takes the place of that share of it: (1 - kr - kt) local, as the dialect of 2013 has it.
    bool adds_to_local = false;
    /// Multiplies the colour, where the mesh has texture coordinates; may be nullptr.
    std::shared_ptr<const Texture> texture = nullptr;
};

/// Something that is lit: a shape, which is a mesh or a quadric, and its material.
struct Object {
    std::string name;
    std::shared_ptr<const Mesh> mesh; ///< nullptr for a quadric
    Material material;
    std::optional<Quadric> quadric = std::nullopt;
    /// Of an object that may move: where it stands. Such an object has an acceleration structure of its own, which
    /// stays when it moves (glint/motion.hpp). Without, the object stands where its mesh says, for good.
    std::optional<RigidTransform> pose = std::nullopt;
};

struct Animation; // glint/animation.hpp

/// Something that gives light.
struct Light {
    enum class Kind : uint8_t {
        surface,     ///< a glowing mesh or quadric, which is seen as color * intensity
        point,       ///< shines from a place; not seen
        directional, ///< shines along a direction, from infinitely far away; not seen
        spot,        ///< a point that shines into a cone; not seen
    };

    std::string name;
    std::shared_ptr<const Mesh> mesh; ///< of a surface, or nullptr
    Color color{1.0f};
    float intensity = 1.0f;
    Kind kind = Kind::surface;
    std::optional<Quadric> quadric = std::nullopt; ///< of a surface without a mesh; an ellipsoid, since light needs a
                                                   ///< place to come from
    /// Where a point or spot light stands. Of a surface: where shadow rays aim, instead of the centre of its area.
    std::optional<Point> position = std::nullopt;
    Vector direction{0.0f, -1.0f, 0.0f}; ///< of a directional or spot light: where it shines; any length but 0
    /// Of a spot light, in radians, 0 <= inner <= outer <= pi: full light within the inner angle around the direction,
    /// none beyond the outer one, in between falling smoothly in the angle's cosine.
    float inner_angle = 0.0f, outer_angle = 0.0f;
    /// Whether light fades with the inverse square of the distance; without, it never does, as in the SDL dialects.
    bool has_falloff = false;

    /// Shadow rays that a glowing mesh gets from each lit point, at random places spread over its area: soft shadows. 1
    /// is one to its position.
    uint32_t shadow_rays = 1;
    /// Instead: shadow rays to the middles of a grid over its area, so many by so many; 0 = no grid.
    uint32_t grid_width = 0, grid_height = 0;
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

    /// A camera that looks from `eye` towards `target` with `up` upwards in the picture, through a window of the given
    /// size at distance 1, or what looks the same from there. The target differs from the eye; `up` is not along the
    /// line between them.
    [[nodiscard]] static Camera look_at(Point eye, Point target, Vector up, float width, float height);
};

/// Where in a pixel its samples lie.
enum class SamplePattern : uint8_t {
    centre,     ///< in the middles of a grid of cells; of a single sample: the pixel's centre
    stratified, ///< at random in the cells of that grid
    jittered,   ///< at random in the pixel
};

/// "centre", "stratified" or "jittered".
[[nodiscard]] GLINT_API std::string_view sample_pattern_name(SamplePattern pattern);

/// How the scene's author wants it rendered; a program may choose otherwise.
struct PictureSettings {
    uint32_t width_px = 256;
    uint32_t height_px = 256;
    uint32_t max_depth = 1; ///< at most this many recursive rays in a row after the primary ray
    uint32_t samples_per_pixel = 1;
    SamplePattern pattern = SamplePattern::centre;
    uint32_t seed = 0; ///< of everything that is random; equal seeds give equal pictures on every machine
    /// t of the tone curve c / (c + t), which each channel of the picture goes through; 0 = no curve.
    float tone_scale = 0.0f;
    /// Samples a pixel that the file asks of a path tracer. Kept, and not used here.
    uint32_t paths_per_pixel = 1;
};

/// How light behaves, where the SDL dialects leave no choice and extensions offer one.
struct OpticsSettings {
    /// Whether surfaces with an index of refraction mirror more at grazing angles (Fresnel's equations for
    /// dielectrics): that share of kt goes along the mirror ray.
    bool fresnel = false;
    /// Whether shadow rays go through transmissive surfaces, straight on and weaker by kt at each. Otherwise those
    /// block light as others do.
    bool shadows_through_glass = false;
};

/// Which kind of surface a triangle belongs to, and which one in the scene's list of that kind.
struct SurfaceRef {
    bool is_light = false;
    uint32_t index = 0; ///< into objects() or lights()
};

/// A complete, valid scene. Nothing in it can change, so any number of threads and renderers may share it.
///
/// Triangles are numbered through the scene: all objects' triangles in the order the objects were added, then all
/// lights' triangles likewise. These numbers are the `triangle_id` that the acceleration structure reports. Quadrics go
/// on from there, in the same order of surfaces.
class GLINT_API Scene {
public:
    [[nodiscard]] const std::vector<Object> &objects() const { return objects_; }
    [[nodiscard]] const std::vector<Light> &lights() const { return lights_; }
    [[nodiscard]] const Camera &camera() const { return camera_; }
    [[nodiscard]] const PictureSettings &picture() const { return picture_; }
    [[nodiscard]] Color background() const { return background_; }
    [[nodiscard]] float ambient() const { return ambient_; }
    [[nodiscard]] const OpticsSettings &optics() const { return optics_; }
    /// How objects and the eye move with time (glint/animation.hpp); nullptr where nothing does by itself.
    [[nodiscard]] const std::shared_ptr<const Animation> &animation() const { return animation_; }

    /// Triangles of all objects and lights together; at most 2^30.
    [[nodiscard]] uint32_t triangle_count() const { return triangle_count_; }
    /// Surfaces in triangle order: every object, then every light.
    [[nodiscard]] uint32_t surface_count() const { return static_cast<uint32_t>(objects_.size() + lights_.size()); }
    /// The mesh of surface s, s < surface_count(); nullptr where it is a quadric, or a light without a surface.
    [[nodiscard]] const Mesh *surface_mesh(uint32_t s) const;
    /// The quadric of surface s, or nullptr.
    [[nodiscard]] const Quadric *surface_quadric(uint32_t s) const;
    /// Surfaces that are quadrics, in order: the first has the number triangle_count() among all that rays can hit.
    [[nodiscard]] const std::vector<uint32_t> &quadric_surfaces() const { return quadric_surfaces_; }
    /// Whether surface s is an object or a light, and which.
    [[nodiscard]] SurfaceRef surface(uint32_t s) const;
    /// Where a single shadow ray to each light aims: its position where it has one, else the area-weighted centroid of
    /// its mesh or the centre of its quadric. The origin for a directional light. In the order of lights().
    [[nodiscard]] const std::vector<Point> &light_positions() const { return light_positions_; }
    /// Triangles that had no area and were left out when the scene was built.
    [[nodiscard]] uint32_t skipped_triangles() const { return skipped_triangles_; }
    /// Whether both come from the same build(), by edits: then they differ in poses and the camera at most.
    [[nodiscard]] bool is_edit_of(const Scene &other) const { return origin_ == other.origin_; }

private:
    friend class SceneBuilder;
    friend class SceneEdit;
    Scene() = default;

    std::vector<Object> objects_;
    std::vector<Light> lights_;
    std::vector<Point> light_positions_;
    std::vector<uint32_t> quadric_surfaces_;
    Camera camera_;
    PictureSettings picture_;
    Color background_{0.0f};
    float ambient_ = 0.0f;
    OpticsSettings optics_;
    std::shared_ptr<const Animation> animation_;
    std::shared_ptr<const char> origin_; ///< the same of all edits of a scene
    uint32_t triangle_count_ = 0;
    uint32_t skipped_triangles_ = 0;
};

/// Coordinates and lengths are at most this large, so that no product inside the tracer overflows a float.
inline constexpr float max_coordinate = 1e12f;
/// Intensities, backgrounds and exponents are at most this large.
inline constexpr float max_intensity = 1e6f;
/// Indices of refraction lie between these.
inline constexpr float least_ior = 0.01f, greatest_ior = 100.0f;
/// Most samples a pixel, and most shadow rays to one light from one point.
inline constexpr uint32_t max_samples = 4096;

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
    SceneBuilder &add_light(Light light);
    SceneBuilder &set_camera(const Camera &camera);
    SceneBuilder &set_picture(const PictureSettings &picture);
    SceneBuilder &set_background(Color background);
    SceneBuilder &set_ambient(float ambient);
    SceneBuilder &set_optics(const OpticsSettings &optics);
    SceneBuilder &set_animation(std::shared_ptr<const Animation> animation);

    /// Checks everything and hands the scene over; the builder is empty afterwards.
    /// Fails, with one diagnostic for each problem, when there is no object, a shape is missing or empty, an index is
    /// out of range, a number is not finite, a fraction is outside [0, 1], kr + kt > 1, a quadric has no real points or
    /// no area, a pose is no rotation, the camera's window has no area or contains the eye's plane, an animation moves
    /// what cannot move, or a limit is passed. Triangles without area are left out and counted; a mesh that has no
    /// other triangles is an error. A scene without lights is allowed here (readers may be stricter).
    [[nodiscard]] Result<std::shared_ptr<const Scene>> build();

private:
    SceneLimits limits_;
    std::vector<Object> objects_;
    std::vector<Light> lights_;
    Camera camera_;
    PictureSettings picture_;
    Color background_{0.0f};
    float ambient_ = 0.0f;
    OpticsSettings optics_;
    std::shared_ptr<const Animation> animation_;
};

} // namespace glint
