// Normals that are not simply a triangle's own, and the colours of textures.
#pragma once

#include "kernel/one_lane.hpp"
#include "kernel/packet/quadric_test.hpp"
#include "kernel/packet/surface_lanes.hpp"
#include "kernel/packet/tile_work.hpp"

namespace glint::HWY_NAMESPACE {

/// The normals again, with those of quadrics in their lanes.
HWY_NOINLINE Points with_quadric_normals(const KernelScene &scene, const DistinctLanes &triangles,
                                         const Points &position, const Points &dir, const Points &normals) {
    const QuadricView &quadrics = scene.geometry.quadrics;
    const uint32_t first = scene.geometry.triangle_count;
    Points result = normals;
    triangles.for_each([&](uint32_t id, FloatMask lanes) {
        if (id < first) return;
        const PlacedQuadric &quadric = quadrics.all[quadrics.places[id - first]];
        result = either(lanes, quadric_normals(quadric, position, dir), result);
    });
    return result;
}

struct ScaledNormals {
    Points normals;
    Floats scale; ///< of what was rounded on the way to the points
};

/// The normals of moving objects turned into the world, and what was rounded on the way there. By value: where vectors
/// come back through references, GCC 12.2 was seen to leave the call out for AVX2.
HWY_NOINLINE ScaledNormals with_instances(const KernelScene &scene, const DistinctLanes &surfaces,
                                          const Points &normals, Floats scale) {
    const InstanceView &instances = scene.geometry.instances;
    ScaledNormals result{normals, scale};
    surfaces.for_each([&](uint32_t surface, FloatMask lanes) {
        const uint32_t place = instances.of_surface[surface];
        if (place == no_instance) return;
        const Instance &instance = instances.all[place];
        result.normals = either(lanes, vector_to_world(instance.pose, normals), result.normals);
        const Floats longer = hn::Max(scale, splat(instance.least_length)) * splat(instance.length_factor);
        result.scale = hn::IfThenElse(lanes, longer, result.scale);
    });
    return result;
}

HWY_INLINE void copy_lane(const Points &p, float (*to)[lane_count]) {
    hn::Store(p.x, floats, to[0]);
    hn::Store(p.y, floats, to[1]);
    hn::Store(p.z, floats, to[2]);
}

/// Shading normals and tints of surface points that lie on facets with the given normals; keeps both.
HWY_NOINLINE Points add_details(const KernelScene &scene, const uint32_t *triangle_id, const uint32_t *surface,
                                uint32_t ray, uint32_t lanes, const Points &position, const Points &dir,
                                const Points &facet, SurfaceDetails &details) {
    alignas(64) float p[3][lane_count], d[3][lane_count], f[3][lane_count], n[3][lane_count], tint[3][lane_count];
    copy_lane(position, p);
    copy_lane(dir, d);
    copy_lane(facet, f);
    copy_lane(facet, n);
    const Floats one = splat(1.0f);
    copy_lane({one, one, one}, tint);
    for (uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
        const uint32_t i = lowest_bit(rest);
        if (!scene.surfaces[surface[i]].details) continue;
        const float at[3] = {p[0][i], p[1][i], p[2][i]}, along[3] = {d[0][i], d[1][i], d[2][i]},
                    flat[3] = {f[0][i], f[1][i], f[2][i]};
        float normal[3], color[3];
        one_lane::detail(scene, surface[i], triangle_id[i], at, along, flat, normal, color);
        for (int axis = 0; axis < 3; ++axis) {
            n[axis][i] = normal[axis];
            tint[axis][i] = color[axis];
        }
    }
    const auto load = [](const float(*from)[lane_count]) {
        return Points{hn::Load(floats, from[0]), hn::Load(floats, from[1]), hn::Load(floats, from[2])};
    };
    details.facet.set(ray, facet);
    details.tint.set(ray, load(tint));
    return load(n);
}

} // namespace glint::HWY_NAMESPACE
