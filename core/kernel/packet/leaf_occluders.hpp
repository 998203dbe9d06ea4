// The triangles of a leaf, several at once, against one shadow ray after another, all from one point. In float, which
// leaves few lanes open, since a shadow ray needs no distance.
#pragma once

#include "kernel/packet/leaf_test.hpp"

namespace glint::HWY_NAMESPACE {

class LeafOccluders : public LeafLanes {
public:
    /// `dir_reach` is the largest coordinate of all directions.
    HWY_INLINE LeafOccluders(const TraceQuestion &question, const uint32_t *words, uint32_t count, uint32_t first,
                             const Point3 &org, float dir_reach)
        : LeafLanes(words, count, first), org_(org), blocking_(valid() & ~passed_by(question)) {
        const NarrowFloats a[3] = {row(0), row(1), row(2)};
        const NarrowFloats e1[3] = {row(3) - a[0], row(4) - a[1], row(5) - a[2]};
        const NarrowFloats e2[3] = {row(6) - a[0], row(7) - a[1], row(8) - a[2]};
        const NarrowFloats s[3] = {narrow_splat(org.x) - a[0], narrow_splat(org.y) - a[1], narrow_splat(org.z) - a[2]};
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            u_[i] = hn::MulSub(s[j], e2[k], s[k] * e2[j]);
            v_[i] = hn::MulSub(e1[j], s[k], e1[k] * s[j]);
            n_[i] = hn::MulSub(e1[j], e2[k], e1[k] * e2[j]);
        }
        offset_ = hn::Neg(fused_dot(n_[0], n_[1], n_[2], s[0], s[1], s[2]));
        const auto e = hn::Max(abs_max(e1[0], e1[1], e1[2]), abs_max(e2[0], e2[1], e2[2]));
        const auto reach = abs_max(s[0], s[1], s[2]), d = narrow_splat(dir_reach), least = narrow_splat(least_margin);
        margin_ = hn::MulAdd(narrow_splat(float_point_error) * (d * e), reach + e, least);
        const auto plane_error = narrow_splat(float_plane_error) * (e * e);
        det_error_ = hn::MulAdd(plane_error, d, least);
        offset_error_ = hn::MulAdd(plane_error, reach, least);
    }

    /// Whether any triangle but `left` is met before t_max. The distance t = offset / det that counts is off by
    /// distance_error of itself.
    [[nodiscard]] HWY_INLINE bool block(const Point3 &dir, uint32_t left, float t_max) const {
        const auto dx = narrow_splat(dir.x), dy = narrow_splat(dir.y), dz = narrow_splat(dir.z);
        const auto det = fused_dot(n_[0], n_[1], n_[2], dx, dy, dz);
        const auto u = fused_dot(u_[0], u_[1], u_[2], dx, dy, dz), v = fused_dot(v_[0], v_[1], v_[2], dx, dy, dz);
        const LeafVerdict verdict(u, v, (det - u) - v, margin_);
        const auto end = narrow_splat(t_max), at_end = end * hn::Abs(det);
        const auto offset = hn::Xor(offset_, sign_of(det)), beyond = offset - at_end;
        const auto room =
            hn::MulAdd(at_end, narrow_splat(2.0f * distance_error), hn::MulAdd(end, det_error_, offset_error_));
        const auto crosses = hn::Gt(hn::Abs(det), det_error_);
        const auto misses = hn::Or(hn::Lt(offset, hn::Neg(offset_error_)), hn::Gt(beyond, room));
        const uint32_t possible = blocking_ & ~verdict.outside() & ~bits_of(narrow_floats, hn::And(crosses, misses));
        if (possible == 0) return false;
        const auto meets = hn::And(hn::Gt(offset, offset_error_), hn::Lt(beyond, hn::Neg(room)));
        const uint32_t blocks = bits_of(narrow_floats, hn::And(crosses, meets)) & verdict.certain() & possible;
        for (uint32_t rest = blocks; rest != 0; rest &= rest - 1) {
            if (id(lowest_bit(rest)) != left) return true;
        }
        uint32_t triangle_id;
        return settle<true>(possible & ~blocks, verdict.certain(), org_, dir, left, t_max, triangle_id,
                            [&](uint32_t lane) { return distance(lane, org_, dir); });
    }

private:
    const Point3 &org_;
    uint32_t blocking_; ///< lanes that may block
    NarrowFloats u_[3], v_[3], n_[3], offset_, margin_, det_error_, offset_error_;
};

} // namespace glint::HWY_NAMESPACE
