// Lights that are more than a place shining the same in all directions, as a level's points see them. The arithmetic is
// that of kernel/incoming_light.hpp, operation by operation; read that first.
#pragma once

#include "kernel/one_lane.hpp"
#include "kernel/packet/reach_surfaces.hpp"

namespace glint::HWY_NAMESPACE {

// See kernel/incoming_light.hpp and kernel/surface_point.hpp.
inline constexpr float strongest_falloff = 1e12f;
inline constexpr float shadow_t_max = 1.0f - 0x1p-22f;

/// Where a light with an area is seen from each point.
HWY_NOINLINE Points light_places(const KernelScene &scene, const LightShading &light, const Points &position,
                                 uint32_t lanes) {
    alignas(64) float p[3][lane_count], places[3][lane_count] = {};
    copy_lane(position, p);
    for (uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
        const uint32_t i = lowest_bit(rest);
        const float at[3] = {p[0][i], p[1][i], p[2][i]};
        float place[3];
        one_lane::place(light, scene.seed, at, place);
        for (int axis = 0; axis < 3; ++axis) places[axis][i] = place[axis];
    }
    return {hn::Load(floats, places[0]), hn::Load(floats, places[1]), hn::Load(floats, places[2])};
}

/// Fringe and falloff; 1 where the light has neither.
HWY_INLINE Floats strength_of(const LightShading &light, const Points &delta, const Points &to_light) {
    const Floats one = splat(1.0f), zero = hn::Zero(floats);
    Floats strength = one;
    if (light.kind == Light::Kind::spot) {
        const Floats cosine = hn::Neg(dot(to_light, points_of(light.direction)));
        const Floats raw = (cosine - splat(light.cos_outer)) * splat(light.inverse_fade);
        const Floats fade = hn::IfThenElseZero(hn::Gt(raw, zero), hn::IfThenElse(hn::Lt(raw, one), raw, one));
        strength = (fade * fade) * (splat(3.0f) - splat(2.0f) * fade);
    }
    if (light.has_falloff) {
        const Floats inverse = one / dot(delta, delta), strongest = splat(strongest_falloff);
        strength = strength * hn::IfThenElse(hn::Lt(inverse, strongest), inverse, strongest);
    }
    return strength;
}

/// Asks for each ray how much light comes through glass, and multiplies strengths by that. Leaves out points that none
/// reaches.
HWY_NOINLINE void weaken_by_glass(const KernelScene &scene, const LightShading &light, TileWork &work,
                                  RaySelection &reached) {
    const RayGroup &shadow = work.shadow;
    for_each_ray(reached, [&](uint32_t ray) {
        const float org[3] = {shadow.org_x[ray], shadow.org_y[ray], shadow.org_z[ray]};
        const float dir[3] = {shadow.dir_x[ray], shadow.dir_y[ray], shadow.dir_z[ray]};
        const uint32_t id = shadow.left[ray];
        const uint32_t left = id < scene.geometry.triangle_count ? id : no_triangle;
        float &strength = work.incoming.strength[ray];
        strength *= one_lane::glass_share(scene, light, org, dir, shadow.t[ray], left);
        if (!(strength > 0.0f)) reached.remove(ray, 1);
    });
}

/// Traces the shadow rays of one light. Returns the points that it reaches, and leaves in work.incoming how; adds the
/// number of rays to `count`.
HWY_NOINLINE RaySelection reached_by_any_light(const KernelScene &scene, const LightShading &light, TileWork &work,
                                               uint32_t &count) {
    const SurfacePoints &points = work.points;
    RayGroup &shadow = work.shadow;
    const bool is_directional = light.kind == Light::Kind::directional;
    RaySelection reached{};
    for_each_vector(points.lit, [&](uint32_t ray, uint32_t lanes) {
        const Points position = points.position.at(ray), normal = points.normal.at(ray);
        const Points facet = scene.has_details ? work.details.facet.at(ray) : normal;
        Points place = points_of(light.position), delta;
        if (is_directional) {
            delta = {splat(-light.direction.x), splat(-light.direction.y), splat(-light.direction.z)};
        } else {
            if (light.area) place = light_places(scene, light, position, lanes);
            delta = difference(place, position);
        }
        const Floats zero = hn::Zero(floats);
        const FloatMask faces =
            hn::And(hn::Gt(dot(normal, delta), zero), hn::And(hn::Gt(dot(facet, delta), zero), mask_of(lanes)));
        const Points to_light = normalized(delta);
        const Floats strength = strength_of(light, delta, to_light);
        const uint32_t facing = bits_of(hn::And(faces, hn::Gt(strength, zero)));
        if (facing == 0) return;
        work.incoming.to_light.set(ray, to_light);
        hn::Store(strength, floats, work.incoming.strength + ray);

        const Floats scale = hn::Load(floats, points.scale + ray);
        if (is_directional) {
            shadow.set_org(ray, offset_point(position, facet, scale));
            shadow.set_dir(ray, delta);
            hn::Store(splat(__FLT_MAX__), floats, shadow.t + ray);
        } else {
            const Points end = offset_point(position, facet, hn::Max(max_abs(delta), scale));
            shadow.set_org(ray, place);
            shadow.set_dir(ray, difference(end, place));
            hn::Store(splat(shadow_t_max), floats, shadow.t + ray);
        }
        hn::Store(hn::Load(uints, work.level->rays.triangle_id + ray), uints, shadow.left + ray);
        reached.add(ray, facing);
    });
    count += reached.count();
    if (reached.empty()) return reached;
    if (scene.shadows_through_glass) {
        weaken_by_glass(scene, light, work, reached);
        return reached;
    }
    const TraceQuestion question{scene.geometry, light.first_triangle, light.triangle_count};
    if (is_directional || light.area) {
        trace<false, true>(question, shadow, reached, work.beams->shadow);
    } else {
        shadow.shared_origin = {light.position.x, light.position.y, light.position.z};
        trace<true, true>(question, shadow, reached, work.beams->shadow);
    }
    return reached;
}

} // namespace glint::HWY_NAMESPACE
