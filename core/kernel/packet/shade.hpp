// Shading a level of rays: what each hit adds to its pixel, and the rays that go on from it. The arithmetic is that of
// scalar_kernel.cpp, operation by operation; read that first.
#pragma once

#include "kernel/packet/pow.hpp"
#include "kernel/packet/ray_level.hpp"
#include "kernel/packet/surface_lanes.hpp"

namespace glint::HWY_NAMESPACE {

// See scalar_kernel.cpp for these three.
inline constexpr float least_branch_weight = 1.0f / 4096.0f;
inline constexpr float offset_of_scale = 0x1p-20f;
inline constexpr float shadow_t_max = 1.0f - 0x1p-22f;

/// Colours of a tile's pixels.
struct alignas(64) TileColors {
    float red[group_size], green[group_size], blue[group_size];

    HWY_INLINE void clear() {
        for (uint32_t ray = 0; ray < group_size; ray += lane_count) {
            hn::Store(hn::Zero(floats), floats, red + ray);
            hn::Store(hn::Zero(floats), floats, green + ray);
            hn::Store(hn::Zero(floats), floats, blue + ray);
        }
    }
    /// Adds weight * color in the given lanes.
    HWY_INLINE void add(uint32_t ray, uint32_t lane_bits, Floats weight, const Points &color) {
        const FloatMask lanes = mask_of(lane_bits);
        add_row(red + ray, lanes, weight * color.x);
        add_row(green + ray, lanes, weight * color.y);
        add_row(blue + ray, lanes, weight * color.z);
    }
    [[nodiscard]] HWY_INLINE Points at(uint32_t ray) const {
        return {hn::Load(floats, red + ray), hn::Load(floats, green + ray), hn::Load(floats, blue + ray)};
    }
    HWY_INLINE void set(uint32_t ray, const Points &color) {
        hn::Store(color.x, floats, red + ray);
        hn::Store(color.y, floats, green + ray);
        hn::Store(color.z, floats, blue + ray);
    }

private:
    static HWY_INLINE void add_row(float *row, FloatMask lanes, Floats term) {
        const Floats old = hn::Load(floats, row);
        hn::Store(hn::IfThenElse(lanes, old + term, old), floats, row);
    }
};

/// Surface points of a level, and how they are lit.
struct alignas(64) SurfacePoints {
    float x[group_size], y[group_size], z[group_size];
    float normal_x[group_size], normal_y[group_size], normal_z[group_size]; ///< faces the viewer
    float scale[group_size];
    float weight[group_size]; ///< of local colour in the pixel
    uint32_t surface[group_size];
    RaySelection lit; ///< points that have local colour
    TileColors local;

    [[nodiscard]] HWY_INLINE Points position(uint32_t ray) const {
        return {hn::Load(floats, x + ray), hn::Load(floats, y + ray), hn::Load(floats, z + ray)};
    }
    [[nodiscard]] HWY_INLINE Points normal(uint32_t ray) const {
        return {hn::Load(floats, normal_x + ray), hn::Load(floats, normal_y + ray), hn::Load(floats, normal_z + ray)};
    }
};

HWY_INLINE Points scaled(const Points &p, Floats s) {
    return {p.x * s, p.y * s, p.z * s};
}
HWY_INLINE Points sum(const Points &a, const Points &b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Points difference(const Points &a, const Points &b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Points normalized(const Points &p) {
    return scaled(p, splat(1.0f) / hn::Sqrt(dot(p, p)));
}
HWY_INLINE Points either(FloatMask first, const Points &a, const Points &b) {
    return {hn::IfThenElse(first, a.x, b.x), hn::IfThenElse(first, a.y, b.y), hn::IfThenElse(first, a.z, b.z)};
}
/// A point moved off its surface along the normal.
HWY_INLINE Points offset_point(const Points &position, const Points &normal, Floats scale) {
    return sum(position, scaled(normal, splat(offset_of_scale) * scale));
}
HWY_INLINE Points points_of(const glm::vec3 &p) {
    return {splat(p.x), splat(p.y), splat(p.z)};
}

/// Everything a tile works with; lies in the worker's memory.
struct TileWork {
    RayLevel *level, *next; ///< two of the levels below
    SurfacePoints points;
    RayGroup shadow;
    TileColors colors;
    RayLevel levels[2];
    BeamHistories *beams;
};

/// Finds surface points, takes misses and lights into account, and puts the rays that go on into work.next and, where a
/// pixel goes both ways, the transmitted ones into `branch`. Returns how many rays go on.
HWY_INLINE uint32_t reach_surfaces(const KernelScene &scene, uint32_t max_depth, TileWork &work, RayLevel &branch) {
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
        const Floats scale = hn::Max(hn::Max(max_abs(position), max_abs(way)), splat(scene.offset_floor));
        const Points n = normals_of(scene, triangles);
        const FloatMask behind = hn::Gt(dot(n, dir), hn::Zero(floats));
        const Points normal = {hn::IfThenElse(behind, hn::Neg(n.x), n.x), hn::IfThenElse(behind, hn::Neg(n.y), n.y),
                               hn::IfThenElse(behind, hn::Neg(n.z), n.z)};
        hn::Store(position.x, floats, points.x + ray);
        hn::Store(position.y, floats, points.y + ray);
        hn::Store(position.z, floats, points.z + ray);
        hn::Store(normal.x, floats, points.normal_x + ray);
        hn::Store(normal.y, floats, points.normal_y + ray);
        hn::Store(normal.z, floats, points.normal_z + ray);
        hn::Store(scale, floats, points.scale + ray);
        const Uints surface = numbers.numbers();
        hn::Store(surface, uints, points.surface + ray);

        Floats share = splat(1.0f);
        if (deeper) {
            Floats reflection = surfaces.number(&SurfaceShading::reflection);
            Floats transmission = surfaces.number(&SurfaceShading::transmission);
            const Floats zero = hn::Zero(floats), least = splat(least_branch_weight);
            const FloatMask both = hn::And(hn::Gt(reflection, zero), hn::Gt(transmission, zero));
            reflection = hn::IfThenElse(hn::And(both, hn::Lt(weight * reflection, least)), zero, reflection);
            transmission = hn::IfThenElse(hn::And(both, hn::Lt(weight * transmission, least)), zero, transmission);
            share = (splat(1.0f) - reflection) - transmission;
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
            const auto through = [&] { return offset_point(position, normal, hn::Neg(scale)); };
            if (mirrored != 0) {
                const Floats twice_n_d = splat(2.0f) * dot(normal, dir);
                Points next_dir = normalized(difference(dir, scaled(normal, twice_n_d)));
                Points next_org = offset_point(position, normal, scale);
                Floats share_of_next = reflection;
                if (transmitted != 0) {
                    const uint32_t branching = mirrored & transmitted;
                    if (branching != 0) go_on(branch, branching, through(), dir, weight * transmission);
                    const FloatMask goes_through = mask_of(transmitted & ~mirrored);
                    next_dir = either(goes_through, dir, next_dir);
                    next_org = either(goes_through, through(), next_org);
                    share_of_next = hn::IfThenElse(goes_through, transmission, reflection);
                }
                go_on(next, mirrored | transmitted, next_org, next_dir, weight * share_of_next);
            } else if (transmitted != 0) {
                go_on(next, transmitted, through(), dir, weight * transmission);
            }
        }
        hn::Store(weight * share, floats, points.weight + ray);
        const uint32_t lit = bits_of(hn::Gt(share, hn::Zero(floats))) & hit;
        if (lit == 0) return;
        points.lit.add(ray, lit);
        points.local.set(ray, surfaces.color(&SurfaceShading::ambient_color));
    });
    return going_on;
}

/// Adds one light's diffuse and specular share to the local colour of all points that it reaches. Returns the number of
/// shadow rays.
HWY_INLINE uint32_t add_light(const KernelScene &scene, const LightShading &light, TileWork &work) {
    SurfacePoints &points = work.points;
    RayGroup &shadow = work.shadow;
    const Points light_position = points_of(light.position);
    shadow.shared_origin = {light.position.x, light.position.y, light.position.z};
    RaySelection reached{};
    for_each_vector(points.lit, [&](uint32_t ray, uint32_t lanes) {
        const Points position = points.position(ray), normal = points.normal(ray);
        const Points delta = difference(light_position, position);
        // A light behind the surface, as the viewer sees it, is hidden by the surface itself.
        const uint32_t facing = bits_of(hn::Gt(dot(normal, delta), hn::Zero(floats))) & lanes;
        if (facing == 0) return;
        const Floats scale = hn::Max(max_abs(delta), hn::Load(floats, points.scale + ray));
        shadow.set_dir(ray, difference(offset_point(position, normal, scale), light_position));
        hn::Store(splat(shadow_t_max), floats, shadow.t + ray);
        hn::Store(hn::Load(uints, work.level->rays.triangle_id + ray), uints, shadow.left + ray);
        reached.add(ray, facing);
    });
    const uint32_t count = reached.count();
    trace<true, true>(TraceQuestion{scene.geometry, light.first_triangle, light.triangle_count}, shadow, reached,
                      work.beams->shadow, RayKind::shadow);
    const Points emission = points_of(light.emission);
    for_each_vector(reached, [&](uint32_t ray, uint32_t lanes) {
        const Points normal = points.normal(ray), dir = work.level->rays.dir(ray);
        const Points to_light = normalized(difference(light_position, points.position(ray)));
        const Points to_viewer = {hn::Neg(dir.x), hn::Neg(dir.y), hn::Neg(dir.z)};
        const DistinctLanes numbers(points.surface + ray, lanes);
        const SurfaceLanes surfaces(scene, numbers);
        const Floats n_l = dot(normal, to_light);
        Floats highlight = hn::Zero(floats);
        const Floats specular = surfaces.number(&SurfaceShading::specular);
        const FloatMask shines = hn::Gt(specular, hn::Zero(floats));
        if ((bits_of(shines) & lanes) != 0) {
            const Floats exponent = surfaces.number(&SurfaceShading::exponent);
            const Floats r_v = (splat(2.0f) * n_l) * dot(normal, to_viewer) - dot(to_light, to_viewer);
            highlight = hn::IfThenElseZero(
                shines, specular * pow_unit(hn::IfThenElseZero(hn::Gt(r_v, hn::Zero(floats)), r_v), exponent));
        }
        const Points diffuse = surfaces.color(&SurfaceShading::diffuse_color);
        const FloatMask lit = mask_of(lanes);
        const Points old = points.local.at(ray);
        const auto with_light = [&](Floats sum_so_far, Floats emitted, Floats reflected) {
            return hn::IfThenElse(lit, sum_so_far + emitted * (reflected * n_l + highlight), sum_so_far);
        };
        points.local.set(ray, {with_light(old.x, emission.x, diffuse.x), with_light(old.y, emission.y, diffuse.y),
                               with_light(old.z, emission.z, diffuse.z)});
    });
    return count;
}

/// Adds the local colours to the pixels.
HWY_INLINE void add_local_colors(TileWork &work) {
    for_each_vector(work.points.lit, [&](uint32_t ray, uint32_t lanes) {
        work.colors.add(ray, lanes, hn::Load(floats, work.points.weight + ray), work.points.local.at(ray));
    });
}

} // namespace glint::HWY_NAMESPACE
