// Batches of rays that somebody else made: cut into groups, put in order and traced.
#pragma once

#include "kernel/packet/trace.hpp"

namespace glint::HWY_NAMESPACE {

/// Rays of a batch as a group. Those whose directions have the same signs stand together, since such rays go through
/// the tree in the same order.
class BatchGroup {
public:
    HWY_INLINE BatchGroup(const RayBatch &batch, size_t first, uint32_t count) : first_(first), count_(count) {
        put_all(batch);
        const Uints sign_bit = hn::Set(uints, 0x80000000u);
        const Points org = splat({rays_.org_x[0], rays_.org_y[0], rays_.org_z[0]});
        const Points dir = splat({rays_.dir_x[0], rays_.dir_y[0], rays_.dir_z[0]});
        uint32_t other_origins = 0;
        Uints other_signs = hn::Zero(uints);
        const auto against = [](Floats a, Floats b) { return hn::Xor(hn::BitCast(uints, a), hn::BitCast(uints, b)); };
        for (uint32_t i = 0; i < count; i += lane_count) {
            const Points o = rays_.org(i), d = rays_.dir(i);
            other_origins |= bits_of(hn::Or(hn::Or(hn::Ne(o.x, org.x), hn::Ne(o.y, org.y)), hn::Ne(o.z, org.z)));
            other_signs =
                hn::Or(hn::Or(other_signs, against(d.x, dir.x)), hn::Or(against(d.y, dir.y), against(d.z, dir.z)));
        }
        shares_origin_ = other_origins == 0;
        one_order_ =
            bits_of(hn::RebindMask(floats, hn::Eq(hn::And(other_signs, sign_bit), hn::Zero(uints)))) == all_lanes;
        if (!one_order_) {
            sort_by_signs();
            put_all(batch);
        }

        rays_.shared_origin = {batch.org_x[first], batch.org_y[first], batch.org_z[first]};
        selection_.clear();
        for (uint32_t i = 0; i < count; i += lane_count) {
            hn::Store(hn::Set(uints, no_triangle), uints, rays_.triangle_id + i);
            hn::Store(hn::Set(uints, no_triangle), uints, rays_.left + i);
            selection_.add(i, count - i >= lane_count ? all_lanes : (1u << (count - i)) - 1);
        }
    }

    template <bool any_hit> HWY_INLINE void trace(const TraceQuestion &question, BeamHistory &history) {
        if (shares_origin_) {
            HWY_NAMESPACE::trace<true, any_hit>(question, rays_, selection_, history);
        } else {
            HWY_NAMESPACE::trace<false, any_hit>(question, rays_, selection_, history);
        }
    }

    HWY_INLINE void take(const HitBatch &hits) const {
        if (one_order_) {
            __builtin_memcpy(hits.t + first_, rays_.t, count_ * sizeof(float));
            __builtin_memcpy(hits.triangle_id + first_, rays_.triangle_id, count_ * sizeof(uint32_t));
            return;
        }
        for (uint32_t i = 0; i < count_; ++i) {
            hits.t[first_ + i] = rays_.t[place_[i]];
            hits.triangle_id[first_ + i] = rays_.triangle_id[place_[i]];
        }
    }
    HWY_INLINE void take(uint8_t *occluded) const {
        for (uint32_t i = 0; i < count_; ++i) {
            const uint32_t place = one_order_ ? i : place_[i];
            occluded[first_ + i] = (selection_.blocks[place / block_size] >> (place % block_size) & 1) != 0 ? 0 : 1;
        }
    }

private:
    /// Finds each ray's place: rays with the same signs stand together, otherwise in the batch's order.
    HWY_INLINE void sort_by_signs() {
        uint32_t starts[9] = {};
        uint8_t signs[group_size];
        for (uint32_t i = 0; i < count_; ++i) {
            signs[i] = static_cast<uint8_t>((__builtin_signbit(rays_.dir_x[i]) ? 1 : 0) |
                                            (__builtin_signbit(rays_.dir_y[i]) ? 2 : 0) |
                                            (__builtin_signbit(rays_.dir_z[i]) ? 4 : 0));
            ++starts[signs[i] + 1];
        }
        for (uint32_t octant = 0; octant < 8; ++octant) starts[octant + 1] += starts[octant];
        for (uint32_t i = 0; i < count_; ++i) place_[i] = static_cast<uint8_t>(starts[signs[i]]++);
    }

    HWY_INLINE void put_all(const RayBatch &batch) {
        put(rays_.org_x, batch.org_x);
        put(rays_.org_y, batch.org_y);
        put(rays_.org_z, batch.org_z);
        put(rays_.dir_x, batch.dir_x);
        put(rays_.dir_y, batch.dir_y);
        put(rays_.dir_z, batch.dir_z);
        put(rays_.t, batch.t_max);
    }
    HWY_INLINE void put(float *to, const float *from) const {
        if (one_order_) {
            __builtin_memcpy(to, from + first_, count_ * sizeof(float));
        } else {
            for (uint32_t i = 0; i < count_; ++i) to[place_[i]] = from[first_ + i];
        }
        for (uint32_t i = count_; i % block_size != 0; ++i) to[i] = to[0]; // lanes that are loaded, but not used
    }

    size_t first_;
    uint32_t count_;
    bool shares_origin_ = false, one_order_ = true;
    uint8_t place_[group_size]; ///< of each ray in the group, where not one_order_
    RayGroup rays_;
    RaySelection selection_;
};

HWY_INLINE void closest_hits(const GeometryView &geometry, const RayBatch &batch, const HitBatch &hits) {
    const TraceQuestion question{geometry};
    BeamHistory history{};
    for (size_t first = 0; first < batch.count; first += group_size) {
        BatchGroup group(batch, first, static_cast<uint32_t>(smaller(batch.count - first, size_t{group_size})));
        group.trace<false>(question, history);
        group.take(hits);
    }
}

HWY_INLINE void any_hits(const GeometryView &geometry, const RayBatch &batch, uint8_t *occluded) {
    const TraceQuestion question{geometry};
    BeamHistory history{};
    for (size_t first = 0; first < batch.count; first += group_size) {
        BatchGroup group(batch, first, static_cast<uint32_t>(smaller(batch.count - first, size_t{group_size})));
        group.trace<true>(question, history);
        group.take(occluded);
    }
}

} // namespace glint::HWY_NAMESPACE
