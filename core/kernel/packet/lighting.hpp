// Light at the surface points of a level. The arithmetic is that of scalar_kernel.cpp, operation by operation; read
// that first.
#pragma once

#include "kernel/packet/incoming_light.hpp"
#include "kernel/packet/pow.hpp"
#include "kernel/packet/reach_surfaces.hpp"

namespace glint::HWY_NAMESPACE {

/// Traces the shadow rays of one light, which start at it and end at the points that face it. Returns the points that
/// the light reaches; adds the number of rays to `count`.
HWY_INLINE RaySelection reached_points(const KernelScene &scene, const LightShading &light, TileWork &work,
                                       uint32_t &count) {
    const SurfacePoints &points = work.points;
    RayGroup &shadow = work.shadow;
    const Points light_position = points_of(light.position);
    shadow.shared_origin = {light.position.x, light.position.y, light.position.z};
    RaySelection reached{};
    WayBounds ways;
    for_each_vector(points.lit, [&](uint32_t ray, uint32_t lanes) {
        const Points position = points.position.at(ray), normal = points.normal.at(ray);
        const Points delta = difference(light_position, position);
        // A light behind the surface, as the viewer sees it, is hidden by the surface itself.
        const FloatMask faces = hn::And(hn::Gt(dot(normal, delta), hn::Zero(floats)), mask_of(lanes));
        const uint32_t facing = bits_of(faces);
        if (facing == 0) return;
        const Floats scale = hn::Max(max_abs(delta), hn::Load(floats, points.scale + ray));
        const Points dir = difference(offset_point(position, normal, scale), light_position);
        shadow.set_dir(ray, dir);
        ways.extend(faces, dir, splat(shadow_t_max));
        hn::Store(splat(shadow_t_max), floats, shadow.t + ray);
        hn::Store(hn::Load(uints, work.level->rays.triangle_id + ray), uints, shadow.left + ray);
        reached.add(ray, facing);
    });
    count += reached.count();
    if (!reached.empty()) {
        const RayEnds ends = ways.ends(shadow.shared_origin, shadow_t_max);
        trace<true, true>({scene.geometry, light.first_triangle, light.triangle_count}, shadow, reached,
                          work.beams->shadow, {.ends = &ends});
    }
    return reached;
}

/// ks times the highlight of light that comes from the given direction.
HWY_INLINE Floats highlight_of(const SurfaceLanes &surfaces, uint32_t lanes, const Points &normal,
                               const Points &to_light, const Points &dir, Floats n_l) {
    const Points to_viewer = {hn::Neg(dir.x), hn::Neg(dir.y), hn::Neg(dir.z)};
    const Floats specular = surfaces.number(&SurfaceShading::specular);
    const FloatMask shines = hn::Gt(specular, hn::Zero(floats));
    if ((bits_of(shines) & lanes) == 0) return hn::Zero(floats);
    const Floats exponent = surfaces.number(&SurfaceShading::exponent);
    const Floats r_v = (splat(2.0f) * n_l) * dot(normal, to_viewer) - dot(to_light, to_viewer);
    return hn::IfThenElseZero(shines,
                              specular * pow_unit(hn::IfThenElseZero(hn::Gt(r_v, hn::Zero(floats)), r_v), exponent));
}

/// A light's diffuse and specular share, added to `color` in the lanes that it reaches.
HWY_INLINE Points with_light(const LightShading &light, const SurfacePoints &points, const SurfaceLanes &surfaces,
                             uint32_t ray, uint32_t lanes, const Points &dir, const Points &color) {
    const Points normal = points.normal.at(ray);
    const Points to_light = normalized(difference(points_of(light.position), points.position.at(ray)));
    const Floats n_l = dot(normal, to_light);
    const Floats highlight = highlight_of(surfaces, lanes, normal, to_light, dir, n_l);
    const Points diffuse = surfaces.color(&SurfaceShading::diffuse_color);
    const FloatMask lit = mask_of(lanes);
    const auto sum = [&](Floats so_far, float emitted, Floats reflected) {
        return hn::IfThenElse(lit, so_far + splat(emitted) * (reflected * n_l + highlight), so_far);
    };
    return {sum(color.x, light.emission.x, diffuse.x), sum(color.y, light.emission.y, diffuse.y),
            sum(color.z, light.emission.z, diffuse.z)};
}

/// The same of any light on any surface.
HWY_NOINLINE Points with_any_light(const KernelScene &scene, const LightShading &light, const TileWork &work,
                                   const SurfaceLanes &surfaces, uint32_t ray, uint32_t lanes, const Points &color) {
    const SurfacePoints &points = work.points;
    const Points normal = points.normal.at(ray), to_light = work.incoming.to_light.at(ray);
    const Floats strength = hn::Load(floats, work.incoming.strength + ray);
    const Floats n_l = dot(normal, to_light);
    const Floats highlight = highlight_of(surfaces, lanes, normal, to_light, work.level->rays.dir(ray), n_l);
    Points diffuse = surfaces.color(&SurfaceShading::diffuse_color);
    if (scene.has_details) diffuse = product(diffuse, work.details.tint.at(ray));
    const Points tint = surfaces.color(&SurfaceShading::highlight_color);
    const FloatMask lit = mask_of(lanes);
    const auto sum = [&](Floats so_far, float emitted, Floats reflected, Floats highlight_tint) {
        const Floats received = splat(emitted) * strength;
        return hn::IfThenElse(lit, so_far + received * (reflected * n_l + highlight * highlight_tint), so_far);
    };
    return {sum(color.x, light.emission.x, diffuse.x, tint.x), sum(color.y, light.emission.y, diffuse.y, tint.y),
            sum(color.z, light.emission.z, diffuse.z, tint.z)};
}

/// The local colours of a level's surface points, added to the pixels. Returns the number of shadow rays.
HWY_NOINLINE uint32_t add_any_local_colors(const KernelScene &scene, TileWork &work) {
    SurfacePoints &points = work.points;
    uint32_t shadow_rays = 0;
    for_each_vector(points.lit, [&](uint32_t ray, uint32_t lanes) {
        const DistinctLanes numbers(points.surface + ray, lanes);
        const Points ambient = SurfaceLanes(scene, numbers).color(&SurfaceShading::ambient_color);
        points.local.set(ray, scene.has_details ? product(ambient, work.details.tint.at(ray)) : ambient);
    });
    for (uint32_t i = 0; i < scene.light_count; ++i) {
        const RaySelection reached = reached_by_any_light(scene, scene.lights[i], work, shadow_rays);
        for_each_vector(reached, [&](uint32_t ray, uint32_t lanes) {
            const DistinctLanes numbers(points.surface + ray, points.lit.lanes(ray));
            const SurfaceLanes surfaces(scene, numbers);
            points.local.set(ray,
                             with_any_light(scene, scene.lights[i], work, surfaces, ray, lanes, points.local.at(ray)));
        });
    }
    for_each_vector(points.lit, [&](uint32_t ray, uint32_t lanes) {
        work.colors.add(ray, lanes, hn::Load(floats, points.weight + ray), points.local.at(ray));
    });
    return shadow_rays;
}

/// Adds the local colours of a level's surface points to the pixels. Returns the number of shadow rays.
HWY_INLINE uint32_t add_local_colors(const KernelScene &scene, TileWork &work) {
    if (HWY_UNLIKELY(!scene.is_lit_plainly)) return add_any_local_colors(scene, work);
    SurfacePoints &points = work.points;
    uint32_t shadow_rays = 0;
    for (uint32_t i = 0; i == 0 || i < scene.light_count; ++i) {
        const bool is_first = i == 0, is_last = i + 1 >= scene.light_count;
        const RaySelection reached =
            scene.light_count == 0 ? RaySelection{} : reached_points(scene, scene.lights[i], work, shadow_rays);
        for_each_vector(points.lit, [&](uint32_t ray, uint32_t lanes) {
            const DistinctLanes numbers(points.surface + ray, lanes);
            const SurfaceLanes surfaces(scene, numbers);
            Points color = is_first ? surfaces.color(&SurfaceShading::ambient_color) : points.local.at(ray);
            const uint32_t reached_lanes = reached.lanes(ray);
            if (reached_lanes != 0) {
                color =
                    with_light(scene.lights[i], points, surfaces, ray, reached_lanes, work.level->rays.dir(ray), color);
            }
            if (is_last) {
                work.colors.add(ray, lanes, hn::Load(floats, points.weight + ray), color);
            } else {
                points.local.set(ray, color);
            }
        });
    }
    return shadow_rays;
}

} // namespace glint::HWY_NAMESPACE
