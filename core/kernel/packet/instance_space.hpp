// Rays, their hits and normals between the space of a moving object and the world. The arithmetic is that of
// math/rigid.hpp, operation by operation; read that first.
#pragma once

#include "accel/instance_tree.hpp"
#include "kernel/packet/box_trace.hpp"
#include "kernel/packet/lanes.hpp"

namespace glint::HWY_NAMESPACE {

HWY_INLINE Points splat(const glm::vec3 &p) {
    return {splat(p.x), splat(p.y), splat(p.z)};
}

HWY_INLINE Points vector_to_object(const RigidTransform &pose, const Points &v) {
    return {dot(splat(pose.x), v), dot(splat(pose.y), v), dot(splat(pose.z), v)};
}
HWY_INLINE Points point_to_object(const RigidTransform &pose, const Points &p) {
    return vector_to_object(pose, difference(p, splat(pose.translation)));
}
HWY_INLINE Points vector_to_world(const RigidTransform &pose, const Points &v) {
    return sum(sum(scaled(splat(pose.x), v.x), scaled(splat(pose.y), v.y)), scaled(splat(pose.z), v.z));
}

/// Those of the rays that are meant, as the instance sees them; they have hit nothing yet.
HWY_NOINLINE void take_inside(const Instance &instance, const RayGroup &rays, const RaySelection &meant,
                              bool shares_origin, RayGroup &own) {
    const RigidTransform &pose = instance.pose;
    const Points origin = point_to_object(pose, splat(rays.shared_origin));
    own.shared_origin = {hn::GetLane(origin.x), hn::GetLane(origin.y), hn::GetLane(origin.z)};
    for_each_vector(meant, [&](uint32_t ray, uint32_t) {
        own.set_org(ray, shares_origin ? origin : point_to_object(pose, rays.org(ray)));
        own.set_dir(ray, vector_to_object(pose, rays.dir(ray)));
        hn::Store(hn::Load(floats, rays.t + ray), floats, own.t + ray);
        const Uints first = hn::Set(uints, instance.first_triangle);
        hn::Store(hn::Load(uints, rays.left + ray) - first, uints, own.left + ray);
        hn::Store(hn::Set(uints, no_triangle), uints, own.triangle_id + ray);
    });
}

/// Gives the rays what they hit of the instance, where that is nearer than what they hit before, or as near and first
/// in the scene.
HWY_NOINLINE void take_hits(const Instance &instance, const RayGroup &own, const RaySelection &meant, RayGroup &rays) {
    for_each_vector(meant, [&](uint32_t ray, uint32_t lanes) {
        const Uints own_id = hn::Load(uints, own.triangle_id + ray);
        const Uints id = own_id + hn::Set(uints, instance.first_triangle);
        const Uints best_id = hn::Load(uints, rays.triangle_id + ray);
        const Floats t = hn::Load(floats, own.t + ray), best = hn::Load(floats, rays.t + ray);
        const uint32_t missed = bits_of(hn::RebindMask(floats, hn::Eq(own_id, hn::Set(uints, no_triangle))));
        const FloatMask is_first = hn::Or(hn::Lt(t, best), hn::RebindMask(floats, hn::Lt(id, best_id)));
        const FloatMask counts = hn::And(mask_of(lanes & ~missed), is_first); // of hits none is farther than the best
        hn::Store(hn::IfThenElse(counts, t, best), floats, rays.t + ray);
        hn::Store(hn::IfThenElse(hn::RebindMask(uints, counts), id, best_id), uints, rays.triangle_id + ray);
    });
}

} // namespace glint::HWY_NAMESPACE
