// Every ray behind one pixel: where its colour comes from.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glint/accel.hpp>
#include <glint/export.hpp>
#include <glint/renderer.hpp>
#include <glint/result.hpp>

namespace glint {

enum class RayKind : uint8_t {
    primary,     ///< from the eye
    mirror,      ///< from a surface that reflects
    transmitted, ///< through a surface that lets light through
    shadow,      ///< from a surface towards a light
};

/// "primary", "mirror", "transmitted" or "shadow".
[[nodiscard]] inline std::string_view ray_kind_name(RayKind kind) {
    constexpr std::string_view names[] = {"primary", "mirror", "transmitted", "shadow"};
    return names[static_cast<int>(kind)];
}

/// What a ray ends at.
enum class RayTarget : uint8_t {
    background, ///< nothing
    object,     ///< one of Scene::objects()
    light,      ///< one of Scene::lights()
};

/// "background", "object" or "light".
[[nodiscard]] inline std::string_view ray_target_name(RayTarget target) {
    constexpr std::string_view names[] = {"background", "object", "light"};
    return names[static_cast<int>(target)];
}

/// The parent of a ray that has none.
inline constexpr uint32_t no_ray = UINT32_MAX;
/// The light of a ray that is not a shadow ray.
inline constexpr uint32_t no_light = UINT32_MAX;

/// One ray of the recursion and what became of it.
struct TracedRay {
    RayKind kind = RayKind::primary;
    uint32_t parent = no_ray; ///< the ray that sent it, by its place in RayTree::rays
    uint32_t level = 0;       ///< rays above it: 0 for a primary ray
    uint32_t sample = 0;      ///< of the pixel's samples

    Point origin{0.0f};     ///< in the scene's units
    Vector direction{0.0f}; ///< unit length
    /// From the origin to what it ends at, in the scene's units; infinite for the background and directional light.
    float distance = 0.0f;

    /// A shadow ray ends at its light or, where less than all of the light comes through, at the nearest surface in its
    /// way.
    RayTarget target = RayTarget::background;
    uint32_t target_index = 0; ///< into objects() or lights()
    std::string target_name;   ///< of the object or light; empty for the background

    /// The ray's share in its sample: its colour counts so much. Of a shadow ray: its parent's local_weight.
    float weight = 1.0f;
    /// The share of what it ends at, without what is mirrored and transmitted there: all of `weight`, where those are
    /// added and do not take its place. 0 for a shadow ray, since what it brings is in its parent's colour.
    float local_weight = 0.0f;
    /// What it ends at, as it shows itself, in linear red, green, blue: a surface in ambient light and the lights that
    /// reach it, a light's glow, the background. Of a shadow ray: what its light adds to its parent's.
    Color local_color{0.0f};
    /// What the ray and all those below it bring to the sample: the sum of local_weight * local_color. Of a shadow ray:
    /// weight * local_color, which its parent's contains.
    Color contribution{0.0f};

    uint32_t light = no_light; ///< that a shadow ray was sent to; an index into lights()
    std::string light_name;    ///< its name
    float light_share = 0.0f;  ///< of its light that comes through, 0 to 1
};

/// The rays behind one pixel, each before those that it sent: its shadow rays first, then the mirrored ray and all
/// below it, then the transmitted one.
///
/// Summed over the rays in this order, local_weight * local_color divided by the number of samples (or rather, times
/// its inverse) is `color`, to the last bit.
struct RayTree {
    uint32_t width_px = 0, height_px = 0; ///< of the picture
    uint32_t x = 0, y = 0;                ///< the pixel; (0, 0) is top left
    uint32_t samples = 1;                 ///< a pixel; each has a primary ray of its own
    uint32_t max_depth = 0;               ///< recursive rays in a row, at most
    std::vector<TracedRay> rays;
    Color color{0.0f};               ///< of the pixel, linear: what render() leaves in Framebuffer::radiance()
    uint8_t rgba8[4] = {0, 0, 0, 0}; ///< and in Framebuffer::rgba8()
};

/// The rays behind pixel (x, y) of the picture that Renderer::render() makes of the accel's scene with these options in
/// a framebuffer of this size. They are found by the functions that define the picture. Traces on the calling thread;
/// takes as long as a Renderer takes to be made and that pixel to be traced.
///
/// Fails with bad_input where the pixel lies outside the picture, the picture has no pixels, or the options' camera or
/// samples are not valid; with limit_exceeded where the pixel has more than max_tree_rays rays.
[[nodiscard]] GLINT_API Result<RayTree> trace_ray_tree(const Accel &accel, const RenderOptions &options,
                                                       uint32_t width_px, uint32_t height_px, uint32_t x, uint32_t y);

/// Most rays of one tree.
inline constexpr uint32_t max_tree_rays = 1u << 20;

} // namespace glint
