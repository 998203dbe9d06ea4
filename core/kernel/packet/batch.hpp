// Batches of rays that somebody else made: cut into groups, put in order and traced.
#pragma once

#include "kernel/packet/trace.hpp"

namespace glint::HWY_NAMESPACE {

/// So many rays of a batch are put in order together: those whose directions have the same signs, since such rays go
/// through a tree in the same order. Beams are best made of neighbours alone; the wide hierarchy's streams get the
/// better the more rays go the same way.
inline constexpr uint32_t beam_window = group_size, stream_window = 8 * group_size;

class BatchWindow {
public:
    HWY_INLINE BatchWindow(const RayBatch &batch, size_t first, uint32_t count)
        : batch_(batch), first_(first), count_(count) {
        one_order_ = have_one_sign(batch.dir_x + first) && have_one_sign(batch.dir_y + first) &&
                     have_one_sign(batch.dir_z + first);
        if (!one_order_) sort_by_signs();
        for (uint32_t i = 0; i < group_size; i += lane_count) {
            hn::Store(hn::Set(uints, no_triangle), uints, rays_.left + i);
        }
    }

    template <typename Trace> HWY_INLINE void for_each_group(Trace &&trace) {
        for (uint32_t begin = 0; begin < count_; begin += group_size) {
            begin_ = begin;
            group_count_ = smaller(count_ - begin, group_size);
            fill();
            trace(rays_, selection_, shares_origin_);
        }
    }

    /// Ray i of the group, as a number in the batch.
    [[nodiscard]] HWY_INLINE size_t ray(uint32_t i) const {
        return first_ + (one_order_ ? begin_ + i : order_[begin_ + i]);
    }

    HWY_INLINE void take(const HitBatch &hits) const {
        if (one_order_) {
            __builtin_memcpy(hits.t + ray(0), rays_.t, group_count_ * sizeof(float));
            __builtin_memcpy(hits.triangle_id + ray(0), rays_.triangle_id, group_count_ * sizeof(uint32_t));
            return;
        }
        for (uint32_t i = 0; i < group_count_; ++i) {
            hits.t[ray(i)] = rays_.t[i];
            hits.triangle_id[ray(i)] = rays_.triangle_id[i];
        }
    }
    HWY_INLINE void take(uint8_t *occluded) const {
        uint32_t i = 0;
        for (; one_order_ && i + 8 <= group_count_; i += 8) {
            // Eight bits become eight bytes: each bit in a byte of its own, made the byte's highest, then its lowest.
            const uint64_t hit = ~(uint32_t{selection_.blocks[i / block_size]} >> (i % block_size)) & 255;
            const uint64_t spread = hit * 0x0101010101010101u & 0x8040201008040201u;
            const uint64_t bytes = (spread + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
            __builtin_memcpy(occluded + ray(i), &bytes, sizeof(bytes));
        }
        for (; i < group_count_; ++i) {
            occluded[ray(i)] = (selection_.blocks[i / block_size] >> (i % block_size) & 1) != 0 ? 0 : 1;
        }
    }

private:
    [[nodiscard]] HWY_INLINE bool have_one_sign(const float *row) const {
        const Uints like = hn::BitCast(uints, splat(row[0]));
        Uints differing = hn::Zero(uints);
        uint32_t i = 0;
        for (; i + lane_count <= count_; i += lane_count) {
            differing = hn::Or(differing, hn::Xor(hn::BitCast(uints, hn::LoadU(floats, row + i)), like));
        }
        const Uints sign = hn::Set(uints, 0x80000000u);
        bool one = hn::AllFalse(uints, hn::Ne(hn::And(differing, sign), hn::Zero(uints)));
        for (; i < count_; ++i) one = one && __builtin_signbit(row[i]) == __builtin_signbit(row[0]);
        return one;
    }

    /// Rays with the same signs stand together, otherwise in the batch's order.
    HWY_INLINE void sort_by_signs() {
        alignas(64) uint32_t octants[stream_window];
        uint32_t starts[9] = {};
        uint32_t done = 0;
        for (; done + lane_count <= count_; done += lane_count) {
            const auto sign = [&](const float *row) {
                return hn::ShiftRight<31>(hn::BitCast(uints, hn::LoadU(floats, row + first_ + done)));
            };
            const Uints x = sign(batch_.dir_x), y = sign(batch_.dir_y), z = sign(batch_.dir_z);
            hn::Store(hn::Or(x, hn::Or(hn::ShiftLeft<1>(y), hn::ShiftLeft<2>(z))), uints, octants + done);
        }
        for (; done < count_; ++done) {
            const auto sign = [&](const float *row) { return __builtin_signbit(row[first_ + done]) ? 1u : 0u; };
            octants[done] = sign(batch_.dir_x) | sign(batch_.dir_y) << 1 | sign(batch_.dir_z) << 2;
        }
        for (uint32_t i = 0; i < count_; ++i) ++starts[octants[i] + 1];
        for (uint32_t octant = 0; octant < 8; ++octant) starts[octant + 1] += starts[octant];
        for (uint32_t i = 0; i < count_; ++i) order_[starts[octants[i]]++] = static_cast<uint16_t>(i);
    }

    /// Makes the group.
    HWY_INLINE void fill() {
        constexpr uint32_t rows = 7;
        float *const to[rows] = {rays_.org_x, rays_.org_y, rays_.org_z, rays_.dir_x, rays_.dir_y, rays_.dir_z, rays_.t};
        const float *from[rows] = {batch_.org_x, batch_.org_y, batch_.org_z, batch_.dir_x,
                                   batch_.dir_y, batch_.dir_z, batch_.t_max};
        if (one_order_) {
            uint32_t i = 0;
            for (; i + lane_count <= group_count_; i += lane_count) {
                for (uint32_t row = 0; row < rows; ++row) {
                    hn::Store(hn::LoadU(floats, from[row] + ray(i)), floats, to[row] + i);
                }
            }
            for (; i < group_count_; ++i) {
                for (uint32_t row = 0; row < rows; ++row) to[row][i] = from[row][ray(i)];
            }
        } else {
            for (uint32_t i = 0; i < group_count_; ++i) {
                const size_t number = ray(i);
                for (uint32_t row = 0; row < rows; ++row) to[row][i] = from[row][number];
            }
        }
        for (uint32_t i = group_count_; i % block_size != 0; ++i) { // lanes that are loaded, but not used
            for (uint32_t row = 0; row < rows; ++row) to[row][i] = to[row][0];
        }
        rays_.shared_origin = {rays_.org_x[0], rays_.org_y[0], rays_.org_z[0]};
        const Points org = splat(rays_.shared_origin);
        FloatMask differs = hn::Ne(org.x, org.x);
        for (uint32_t i = 0; i < group_count_; i += lane_count) {
            const Points o = rays_.org(i);
            differs = hn::Or(differs, hn::Or(hn::Or(hn::Ne(o.x, org.x), hn::Ne(o.y, org.y)), hn::Ne(o.z, org.z)));
            hn::Store(hn::Set(uints, no_triangle), uints, rays_.triangle_id + i);
        }
        shares_origin_ = bits_of(differs) == 0;
        for (uint32_t b = 0; b < block_count; ++b) {
            const uint32_t first = b * block_size, rest = group_count_ > first ? group_count_ - first : 0;
            selection_.blocks[b] = static_cast<uint16_t>(rest >= block_size ? 0xffffu : (1u << rest) - 1);
        }
    }

    const RayBatch &batch_;
    size_t first_;
    uint32_t count_, begin_ = 0, group_count_ = 0;
    bool shares_origin_ = false, one_order_ = true;
    uint16_t order_[stream_window]; ///< the rays' numbers from first_ on, where not one_order_
    RayGroup rays_;
    RaySelection selection_;
};

template <bool any_hit, typename Answers>
HWY_INLINE void answer(const GeometryView &geometry, const RayBatch &batch, const Answers &answers) {
    const TraceQuestion question{geometry};
    const size_t window_size = geometry.wide_nodes ? stream_window : beam_window;
    BeamHistory history{};
    for (size_t first = 0; first < batch.count; first += window_size) {
        BatchWindow window(batch, first, static_cast<uint32_t>(smaller(batch.count - first, window_size)));
        window.for_each_group([&](RayGroup &rays, RaySelection &selection, bool shares_origin) {
            if (shares_origin) {
                RayHint hint;
                RayEnds ends{};
                if constexpr (any_hit) {
                    ends = find_ends(rays, selection);
                    if (ends.way < __FLT_MAX__) hint.ends = &ends;
                }
                trace<true, any_hit>(question, rays, selection, history, hint);
            } else {
                trace<false, any_hit>(question, rays, selection, history);
            }
            window.take(answers);
        });
    }
}

HWY_INLINE void closest_hits(const GeometryView &geometry, const RayBatch &batch, const HitBatch &hits) {
    answer<false>(geometry, batch, hits);
}

HWY_INLINE void any_hits(const GeometryView &geometry, const RayBatch &batch, uint8_t *occluded) {
    answer<true>(geometry, batch, occluded);
}

} // namespace glint::HWY_NAMESPACE
