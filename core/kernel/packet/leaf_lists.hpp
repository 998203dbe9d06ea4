// The triangles of a leaf, several at once, against one ray after another: what does not depend on the ray is worked
// out once.
#pragma once

#include "kernel/packet/leaf_test.hpp"

namespace glint::HWY_NAMESPACE {

using HalfLeafTag = hn::Half<NarrowTag>;
using HalfLeafDoubleTag = hn::Rebind<double, HalfLeafTag>;
using HalfLeafDoubles = hn::Vec<HalfLeafDoubleTag>;
inline constexpr HalfLeafTag half_leaf_floats;
inline constexpr HalfLeafDoubleTag half_leaf_doubles;

HWY_INLINE NarrowFloats both_halves(HalfLeafDoubles lower, HalfLeafDoubles upper) {
    return hn::Combine(narrow_floats, hn::DemoteTo(half_leaf_floats, upper), hn::DemoteTo(half_leaf_floats, lower));
}

/// For rays that start anywhere: see TriangleFromAnywhere.
class LeafFromAnywhere : public LeafLanes {
public:
    uint32_t passes = 0; ///< lanes that do not block

    /// `dir_reach` is the largest coordinate of all directions.
    HWY_INLINE LeafFromAnywhere(const uint32_t *words, uint32_t count, uint32_t first, float dir_reach)
        : LeafLanes(words, count, first),
          ax_(row(0)),
          ay_(row(1)),
          az_(row(2)),
          e1x_(row(3) - ax_),
          e1y_(row(4) - ay_),
          e1z_(row(5) - az_),
          e2x_(row(6) - ax_),
          e2y_(row(7) - ay_),
          e2z_(row(8) - az_),
          nx_(hn::MulSub(e1y_, e2z_, e1z_ * e2y_)),
          ny_(hn::MulSub(e1z_, e2x_, e1x_ * e2z_)),
          nz_(hn::MulSub(e1x_, e2y_, e1y_ * e2x_)),
          margin_(hn::Zero(narrow_floats)),
          margin_per_s_(margin_),
          margin_per_q_(margin_),
          plane_error_(margin_) {
        const auto e = hn::Max(abs_max(e1x_, e1y_, e1z_), abs_max(e2x_, e2y_, e2z_));
        margin_per_s_ = narrow_splat(from_anywhere_error * dir_reach) * e;
        margin_ = hn::MulAdd(margin_per_s_, e + e, narrow_splat(least_margin));
        margin_per_q_ = narrow_splat(from_anywhere_cross_error) * e;
        plane_error_ = narrow_splat(float_plane_error) * (e * e);
    }

    /// `dir_reach` is the largest coordinate of this ray's direction.
    template <bool any_hit> HWY_INLINE bool hit(const Point3 &org, const Point3 &dir, float dir_reach, uint32_t left,
                                                float &best_t, uint32_t &best_id) const {
        const auto dx = narrow_splat(dir.x), dy = narrow_splat(dir.y), dz = narrow_splat(dir.z);
        const auto sx = narrow_splat(org.x) - ax_, sy = narrow_splat(org.y) - ay_, sz = narrow_splat(org.z) - az_;
        const auto qx = hn::MulSub(dy, sz, dz * sy), qy = hn::MulSub(dz, sx, dx * sz), qz = hn::MulSub(dx, sy, dy * sx);
        const auto s = abs_max(sx, sy, sz);
        const auto margin =
            hn::MulAdd(margin_per_q_, (hn::Abs(qx) + hn::Abs(qy)) + hn::Abs(qz), hn::MulAdd(margin_per_s_, s, margin_));
        const auto det = fused_dot(nx_, ny_, nz_, dx, dy, dz), u = fused_dot(e2x_, e2y_, e2z_, qx, qy, qz),
                   minus_v = fused_dot(e1x_, e1y_, e1z_, qx, qy, qz);
        const LeafVerdict verdict(u, hn::Neg(minus_v), (det - u) + minus_v, margin);
        // Most often that is the triangle that the ray comes from, a little behind it.
        const auto height = fused_dot(nx_, ny_, nz_, sx, sy, sz), least = narrow_splat(least_margin);
        const auto way_back = hn::Xor(height, sign_of(det));
        const auto is_behind = hn::Gt(way_back, hn::MulAdd(plane_error_, s, least));
        const auto crosses = hn::Gt(hn::Abs(det), hn::MulAdd(plane_error_, narrow_splat(dir_reach), least));
        const uint32_t possible =
            valid() & ~verdict.outside() & ~passes & ~bits_of(narrow_floats, hn::And(is_behind, crosses));
        if (possible == 0) return false;
        return settle<any_hit>(possible, verdict.certain(), org, dir, left, best_t, best_id,
                               [&](uint32_t lane) { return distance(lane, org, dir); });
    }

private:
    NarrowFloats ax_, ay_, az_, e1x_, e1y_, e1z_, e2x_, e2y_, e2z_, nx_, ny_, nz_;
    NarrowFloats margin_, margin_per_s_, margin_per_q_;
    NarrowFloats plane_error_; ///< of n . x, where x is 1
};

/// Rays from one point that look for the closest hit: see TriangleFromPoint.
class LeafFromPoint : public LeafLanes {
public:
    HWY_INLINE LeafFromPoint(const uint32_t *words, uint32_t count, uint32_t first, const Point3 &org, float dir_reach)
        : LeafLanes(words, count, first), org_(org) {
        const Half lower(*this, org, false), upper(*this, org, true);
        for (int i = 0; i < 3; ++i) {
            u_[i] = both_halves(lower.u[i], upper.u[i]);
            v_[i] = both_halves(lower.v[i], upper.v[i]);
            n_[i] = both_halves(lower.n[i], upper.n[i]);
        }
        offset_ = both_halves(lower.offset, upper.offset);
        const auto e = hn::Max(abs_max(row(3) - row(0), row(4) - row(1), row(5) - row(2)),
                               abs_max(row(6) - row(0), row(7) - row(1), row(8) - row(2)));
        const auto s = abs_max(both_halves(lower.s[0], upper.s[0]), both_halves(lower.s[1], upper.s[1]),
                               both_halves(lower.s[2], upper.s[2]));
        margin_ = narrow_splat(from_point_error * dir_reach) * e * (s + e) + narrow_splat(least_margin);
        grazing_ = narrow_splat(least_slope) * ((hn::Abs(n_[0]) + hn::Abs(n_[1])) + hn::Abs(n_[2]));
    }

    /// Arguments and result as settle() has them.
    HWY_INLINE bool hit(const Point3 &dir, float dir_reach, uint32_t left, float &best_t, uint32_t &best_id) const {
        const auto dx = narrow_splat(dir.x), dy = narrow_splat(dir.y), dz = narrow_splat(dir.z);
        const auto det = (n_[0] * dx + n_[1] * dy) + n_[2] * dz;
        const auto u = fused_dot(u_[0], u_[1], u_[2], dx, dy, dz), v = fused_dot(v_[0], v_[1], v_[2], dx, dy, dz);
        const LeafVerdict verdict(u, v, (det - u) - v, margin_);
        uint32_t possible = valid() & ~verdict.outside();
        if (possible == 0) return false;
        const uint32_t grazing = bits_of(narrow_floats, hn::Lt(hn::Abs(det), grazing_ * narrow_splat(dir_reach)));
        const auto distances = offset_ / det;
        const uint32_t in_reach = bits_of(narrow_floats, hn::And(hn::Gt(distances, hn::Zero(narrow_floats)),
                                                                 hn::Le(distances, narrow_splat(best_t))));
        possible &= in_reach | ~verdict.certain() | grazing;
        alignas(32) float t[narrow_lanes];
        hn::Store(distances, narrow_floats, t);
        return settle<false>(possible, verdict.certain(), org_, dir, left, best_t, best_id, [&](uint32_t lane) {
            return (grazing >> lane & 1) != 0 ? distance(lane, org_, dir) : t[lane];
        });
    }

    /// What has been worked out, to be read lane by lane.
    struct Rows {
        alignas(32) float u[3][narrow_lanes], v[3][narrow_lanes], n[3][narrow_lanes];
        alignas(32) float offset[narrow_lanes], margin[narrow_lanes], grazing[narrow_lanes];
    };
    HWY_INLINE Rows rows() const {
        Rows rows;
        for (int i = 0; i < 3; ++i) {
            hn::Store(u_[i], narrow_floats, rows.u[i]);
            hn::Store(v_[i], narrow_floats, rows.v[i]);
            hn::Store(n_[i], narrow_floats, rows.n[i]);
        }
        hn::Store(offset_, narrow_floats, rows.offset);
        hn::Store(margin_, narrow_floats, rows.margin);
        hn::Store(grazing_, narrow_floats, rows.grazing);
        return rows;
    }

private:
    /// In double, for half of the lanes: planes as ExactPlane has them, and the rest.
    struct Half {
        HalfLeafDoubles n[3], s[3], u[3], v[3], offset;

        HWY_INLINE Half(const LeafLanes &leaf, const Point3 &org, bool is_upper) {
            const auto row = [&](uint32_t r) {
                const auto all = leaf.row(r);
                return hn::PromoteTo(half_leaf_doubles, is_upper ? hn::UpperHalf(half_leaf_floats, all)
                                                                 : hn::LowerHalf(half_leaf_floats, all));
            };
            const auto set = [](float value) { return hn::Set(half_leaf_doubles, double(value)); };
            const HalfLeafDoubles a[3] = {row(0), row(1), row(2)};
            const HalfLeafDoubles e1[3] = {row(3) - a[0], row(4) - a[1], row(5) - a[2]};
            const HalfLeafDoubles e2[3] = {row(6) - a[0], row(7) - a[1], row(8) - a[2]};
            s[0] = set(org.x) - a[0];
            s[1] = set(org.y) - a[1];
            s[2] = set(org.z) - a[2];
            for (int i = 0; i < 3; ++i) {
                const int j = (i + 1) % 3, k = (i + 2) % 3;
                n[i] = e1[j] * e2[k] - e1[k] * e2[j];
                u[i] = s[j] * e2[k] - s[k] * e2[j];
                v[i] = e1[j] * s[k] - e1[k] * s[j];
            }
            offset = (n[0] * (a[0] - set(org.x)) + n[1] * (a[1] - set(org.y))) + n[2] * (a[2] - set(org.z));
        }
    };

    const Point3 &org_;
    NarrowFloats u_[3], v_[3], n_[3], offset_, margin_, grazing_;
};

} // namespace glint::HWY_NAMESPACE
