// Batches of rays that somebody else made: cut into groups and traced.
#pragma once

#include "kernel/packet/trace.hpp"

namespace glint::HWY_NAMESPACE {

/// Rays first .. first + count of the batch as a group; whether they share an origin.
HWY_INLINE bool load_group(const RayBatch &batch, size_t first, uint32_t count, RayGroup &rays,
                           RaySelection &selection) {
    const auto copy = [&](float *to, const float *from) {
        __builtin_memcpy(to, from + first, count * sizeof(float));
        for (uint32_t i = count; i % lane_count != 0; ++i) to[i] = to[0];
    };
    copy(rays.dir_x, batch.dir_x);
    copy(rays.dir_y, batch.dir_y);
    copy(rays.dir_z, batch.dir_z);
    copy(rays.t, batch.t_max);
    rays.shared_origin = {batch.org_x[first], batch.org_y[first], batch.org_z[first]};
    uint32_t differing = 0;
    const Points shared = splat(rays.shared_origin);
    copy(rays.org_x, batch.org_x);
    copy(rays.org_y, batch.org_y);
    copy(rays.org_z, batch.org_z);
    selection.clear();
    for (uint32_t i = 0; i < count; i += lane_count) {
        const Points org = rays.org(i);
        differing |= bits_of(hn::Or(hn::Or(hn::Ne(org.x, shared.x), hn::Ne(org.y, shared.y)), hn::Ne(org.z, shared.z)));
        hn::Store(hn::Set(uints, no_triangle), uints, rays.triangle_id + i);
        hn::Store(hn::Set(uints, no_triangle), uints, rays.left + i);
        selection.add(i, count - i >= lane_count ? all_lanes : (1u << (count - i)) - 1);
    }
    return differing == 0;
}

HWY_INLINE void closest_hits(const GeometryView &geometry, const RayBatch &batch, const HitBatch &hits) {
    RayGroup rays;
    RaySelection selection;
    const TraceQuestion question{geometry};
    BeamHistory history{};
    for (size_t first = 0; first < batch.count; first += group_size) {
        const auto count = static_cast<uint32_t>(smaller(batch.count - first, size_t{group_size}));
        if (load_group(batch, first, count, rays, selection)) {
            trace<true, false>(question, rays, selection, history);
        } else {
            trace<false, false>(question, rays, selection, history);
        }
        __builtin_memcpy(hits.t + first, rays.t, count * sizeof(float));
        __builtin_memcpy(hits.triangle_id + first, rays.triangle_id, count * sizeof(uint32_t));
    }
}

HWY_INLINE void any_hits(const GeometryView &geometry, const RayBatch &batch, uint8_t *occluded) {
    RayGroup rays;
    RaySelection selection;
    const TraceQuestion question{geometry};
    BeamHistory history{};
    for (size_t first = 0; first < batch.count; first += group_size) {
        const auto count = static_cast<uint32_t>(smaller(batch.count - first, size_t{group_size}));
        if (load_group(batch, first, count, rays, selection)) {
            trace<true, true>(question, rays, selection, history);
        } else {
            trace<false, true>(question, rays, selection, history);
        }
        for (uint32_t i = 0; i < count; ++i) {
            occluded[first + i] = (selection.blocks[i / block_size] >> (i % block_size) & 1) != 0 ? 0 : 1;
        }
    }
}

} // namespace glint::HWY_NAMESPACE
