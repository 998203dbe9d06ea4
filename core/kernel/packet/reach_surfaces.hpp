// From hits to surface points, and the rays that go on from there. The arithmetic is that of scalar_kernel.cpp,
// operation by operation; read that first.
#pragma once

#include "kernel/packet/refraction.hpp"
#include "kernel/packet/surface_normals.hpp"
#include "kernel/packet/tile_work.hpp"

namespace glint::HWY_NAMESPACE {

// See scalar_kernel.cpp for both.
inline constexpr float least_branch_weight = 1.0f / 4096.0f;
inline constexpr float offset_of_scale = 0x1p-20f;

/// A point moved off its surface along the normal.
HWY_INLINE Points offset_point(const Points &position, const Points &normal, Floats scale) {
    return sum(position, scaled(normal, splat(offset_of_scale) * scale));
}
HWY_INLINE Points points_of(const glm::vec3 &p) {
    return {splat(p.x), splat(p.y), splat(p.z)};
}

/// What reach_surfaces<true>() may be asked about: flat triangles that stand still, in one colour each, that let light
/// straight through if at all. It is a twentieth of a frame quicker at them.
HWY_INLINE bool has_plain_surfaces(const KernelScene &scene) {
    return scene.geometry.quadrics.count == 0 && scene.geometry.instances.count == 0 && !scene.has_details &&
           !scene.has_refraction && !scene.has_additions;
}

/// Finds surface points, takes misses and lights into account, and puts the rays that go on into work.next and, where a
/// pixel goes both ways, the transmitted ones into `branch`. Returns how many rays go on.
template <bool is_plain>
HWY_NOINLINE uint32_t reach_surfaces(const KernelScene &scene, uint32_t max_depth, TileWork &work, RayLevel &branch) {
    const RayLevel &level = *work.level;
    RayLevel &next = *work.next;
    SurfacePoints &points = work.points;
    const bool deeper = level.depth < max_depth;
    points.lit.clear();
    next.selection.clear();
    branch.selection.clear();
    next.depth = branch.depth = level.depth + 1;
    const Points background = points_of(scene.background);
    const Points shared_origin = splat(level.rays.shared_origin);
    uint32_t going_on = 0;

    for_each_vector(level.selection, [&](uint32_t ray, uint32_t lanes) {
        const Uints ids = hn::Load(uints, level.rays.triangle_id + ray);
        const Floats weight = hn::Load(floats, level.weight + ray);
        const uint32_t missed = bits_of(hn::RebindMask(floats, hn::Eq(ids, hn::Set(uints, no_triangle)))) & lanes;
        if (missed != 0) work.colors.add(ray, missed, weight, background);
        uint32_t hit = lanes & ~missed;
        if (hit == 0) return;

        const DistinctLanes triangles(level.rays.triangle_id + ray, hit);
        const TriangleSurface *triangle_surfaces = scene.geometry.surfaces;
        const DistinctLanes numbers(triangles, [=](uint32_t id) { return triangle_surfaces[id].surface; });
        const SurfaceLanes surfaces(scene, numbers);
        const uint32_t glowing = surfaces.lights() & hit;
        if (glowing != 0) {
            work.colors.add(ray, glowing, weight, surfaces.color(&SurfaceShading::emission));
            hit &= ~glowing;
            if (hit == 0) return;
        }

        const Points dir = level.rays.dir(ray);
        const Points way = scaled(dir, hn::Load(floats, level.rays.t + ray));
        const Points position = sum(level.depth == 0 ? shared_origin : level.rays.org(ray), way);
        Floats scale = hn::Max(hn::Max(max_abs(position), max_abs(way)), splat(scene.offset_floor));
        Points n = normals_of(scene, triangles);
        if (!is_plain && scene.geometry.instances.count != 0) {
            const ScaledNormals turned = with_instances(scene, numbers, n, scale);
            n = turned.normals;
            scale = turned.scale;
        }
        if (!is_plain && scene.geometry.quadrics.count != 0) {
            n = with_quadric_normals(scene, triangles, position, dir, n);
        }
        const FloatMask behind = hn::Gt(dot(n, dir), hn::Zero(floats));
        const Points facet = {hn::IfThenElse(behind, hn::Neg(n.x), n.x), hn::IfThenElse(behind, hn::Neg(n.y), n.y),
                              hn::IfThenElse(behind, hn::Neg(n.z), n.z)};
        const Uints surface = numbers.numbers();
        hn::Store(surface, uints, points.surface + ray);
        Points normal = facet;
        if (!is_plain && scene.has_details) {
            normal = add_details(scene, level.rays.triangle_id + ray, points.surface + ray, ray, hit, position, dir,
                                 facet, work.details);
        }
        points.position.set(ray, position);
        points.normal.set(ray, normal);
        hn::Store(scale, floats, points.scale + ray);

        Floats share = splat(1.0f);
        if (deeper) {
            Floats reflection = surfaces.number(&SurfaceShading::reflection);
            Floats transmission = surfaces.number(&SurfaceShading::transmission);
            const Floats zero = hn::Zero(floats), least = splat(least_branch_weight);
            Points dir_through = dir;
            if (!is_plain && scene.has_refraction) {
                const uint32_t crossing = bits_of(hn::Gt(transmission, zero)) & hit;
                MediaLanes media = media_at(level, ray);
                set_media(next, ray, media);
                if (crossing != 0) {
                    const RefractedLanes refracted = refract(scene, media, surface, dir, normal, crossing);
                    const FloatMask crosses = mask_of(crossing);
                    const Floats turned = transmission * refracted.reflection;
                    reflection = hn::IfThenElse(crosses, reflection + turned, reflection);
                    transmission = hn::IfThenElse(crosses, transmission - turned, transmission);
                    dir_through = either(crosses, refracted.dir, dir);
                    set_media(branch, ray, refracted.media);
                }
            }
            const FloatMask both = hn::And(hn::Gt(reflection, zero), hn::Gt(transmission, zero));
            reflection = hn::IfThenElse(hn::And(both, hn::Lt(weight * reflection, least)), zero, reflection);
            transmission = hn::IfThenElse(hn::And(both, hn::Lt(weight * transmission, least)), zero, transmission);
            if (!is_plain && scene.has_additions) {
                const Floats replaced = surfaces.number(&SurfaceShading::replaced);
                share = (splat(1.0f) - replaced * reflection) - replaced * transmission;
            } else {
                share = (splat(1.0f) - reflection) - transmission;
            }
            const uint32_t mirrored = bits_of(hn::Gt(reflection, zero)) & hit;
            const uint32_t transmitted = bits_of(hn::Gt(transmission, zero)) & hit;
            const auto go_on = [&](RayLevel &to, uint32_t bits, const Points &org, const Points &direction,
                                   Floats next_weight) {
                to.rays.set_org(ray, org);
                to.rays.set_dir(ray, direction);
                hn::Store(next_weight, floats, to.weight + ray);
                hn::Store(ids, uints, to.rays.left + ray);
                hn::Store(surface, uints, to.left_surface + ray);
                hn::Store(splat(__FLT_MAX__), floats, to.rays.t + ray);
                hn::Store(hn::Set(uints, no_triangle), uints, to.rays.triangle_id + ray);
                to.selection.add(ray, bits);
                going_on += static_cast<uint32_t>(__builtin_popcount(bits));
            };
            const auto through = [&] { return offset_point(position, facet, hn::Neg(scale)); };
            // Those that go through alone go on in the media behind the surface.
            if (!is_plain && scene.has_refraction && (transmitted & ~mirrored) != 0) {
                const FloatMask goes_through = mask_of(transmitted & ~mirrored);
                set_media(next, ray, either(goes_through, media_at(branch, ray), media_at(next, ray)));
            }
            if (mirrored != 0) {
                const Floats twice_n_d = splat(2.0f) * dot(normal, dir);
                Points next_dir = normalized(difference(dir, scaled(normal, twice_n_d)));
                Points next_org = offset_point(position, facet, scale);
                Floats share_of_next = reflection;
                if (transmitted != 0) {
                    const uint32_t branching = mirrored & transmitted;
                    if (branching != 0) go_on(branch, branching, through(), dir_through, weight * transmission);
                    const FloatMask goes_through = mask_of(transmitted & ~mirrored);
                    next_dir = either(goes_through, dir_through, next_dir);
                    next_org = either(goes_through, through(), next_org);
                    share_of_next = hn::IfThenElse(goes_through, transmission, reflection);
                }
                go_on(next, mirrored | transmitted, next_org, next_dir, weight * share_of_next);
            } else if (transmitted != 0) {
                go_on(next, transmitted, through(), dir_through, weight * transmission);
            }
        }
        hn::Store(weight * share, floats, points.weight + ray);
        const uint32_t lit = bits_of(hn::Gt(share, hn::Zero(floats))) & hit;
        if (lit == 0) return;
        points.lit.add(ray, lit);
    });
    return going_on;
}

} // namespace glint::HWY_NAMESPACE
