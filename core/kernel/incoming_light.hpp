// Light that comes to a surface point, and what stands in its way.
#pragma once

#include <limits>

#include "kernel/glass_shadow.hpp"
#include "kernel/light_places.hpp"
#include "kernel/surface_point.hpp"

namespace glint {

/// Falloff counts as if no light came nearer than a millionth of the scene's unit.
inline constexpr float strongest_falloff = 1e12f;

/// A light as a point sees it, if nothing is in between.
struct IncomingLight {
    glm::vec3 place;    ///< that it comes from; of no use for directional light
    glm::vec3 delta;    ///< towards it: the way to its place or, for directional light, a unit vector
    glm::vec3 to_light; ///< the same as a unit vector
    float strength;     ///< 1, or less in a spot's fringe and with falloff
};

inline bool faces(const SurfacePoint &point, const glm::vec3 &delta) {
    return dot(point.normal, delta) > 0.0f && dot(point.facet, delta) > 0.0f;
}

/// Towards the light; its place is told, to_light and strength are not.
inline IncomingLight direction_to(const KernelScene &scene, const LightShading &light, const SurfacePoint &point) {
    IncomingLight incoming{};
    if (light.kind == Light::Kind::directional) {
        incoming.delta = -light.direction;
        return incoming;
    }
    incoming.place = light.area ? light_place(light, scene.seed, point.position) : light.position;
    incoming.delta = incoming.place - point.position;
    return incoming;
}

/// to_light and strength, for a light that the point faces.
inline void find_strength(const LightShading &light, IncomingLight &incoming) {
    incoming.to_light = normalize(incoming.delta);
    incoming.strength = 1.0f;
    if (light.kind == Light::Kind::spot) {
        const float cosine = -dot(incoming.to_light, light.direction);
        const float raw = (cosine - light.cos_outer) * light.inverse_fade;
        const float fade = raw > 0.0f ? (raw < 1.0f ? raw : 1.0f) : 0.0f;
        incoming.strength = (fade * fade) * (3.0f - 2.0f * fade);
    }
    if (light.has_falloff) {
        const float inverse = 1.0f / dot(incoming.delta, incoming.delta);
        incoming.strength *= inverse < strongest_falloff ? inverse : strongest_falloff;
    }
}

/// The ray between a light and a point, from the end that packets share: it begins at the light or, for directional
/// light, at the point.
struct ShadowRay {
    Ray ray;
    float t_max;
};

inline ShadowRay shadow_ray(const LightShading &light, const IncomingLight &incoming, const SurfacePoint &point) {
    if (light.kind == Light::Kind::directional) {
        return {{offset_point(point, point.scale, 1.0f), incoming.delta}, std::numeric_limits<float>::max()};
    }
    const float distance = max_abs(incoming.delta);
    const glm::vec3 end = offset_point(point, larger(distance, point.scale), 1.0f);
    return {{incoming.place, end - incoming.place}, shadow_t_max};
}

/// Share of the light that comes through to a point which lies on the flat triangle `left`, if any.
inline float unblocked_share(const KernelScene &scene, const LightShading &light, const ShadowRay &shadow,
                             uint32_t left) {
    if (scene.shadows_through_glass) return share_through_glass(scene, light, shadow.ray, shadow.t_max, left);
    const auto can_block = [&](uint32_t id) { return id != left && id - light.first_triangle >= light.triangle_count; };
    const PreparedRay ray(shadow.ray, scene.geometry.bounds);
    return any_hit(scene.geometry, ray, shadow.t_max, can_block) ? 0.0f : 1.0f;
}

} // namespace glint
