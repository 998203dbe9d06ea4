// One ray against the triangles of a leaf, several at once.
#pragma once

#include "kernel/packet/group_test.hpp"

namespace glint::HWY_NAMESPACE {

/// The triangles of a leaf from number `first` on, one a lane.
class LeafLanes {
public:
    /// Of `count` altogether.
    HWY_INLINE LeafLanes(const uint32_t *words, uint32_t count, uint32_t first)
        : words_(words), count_(count), first_(first) {}

    /// Lanes that hold a triangle.
    [[nodiscard]] HWY_INLINE uint32_t valid() const { return (1u << smaller(count_ - first_, narrow_lanes)) - 1; }

    /// Those that do not block.
    [[nodiscard]] HWY_INLINE uint32_t passed_by(const TraceQuestion &question) const {
        const hn::RebindToUnsigned<NarrowTag> narrow_uints;
        const auto ids = hn::LoadU(narrow_uints, words_ + (9 * count_ + first_));
        return bits_of(narrow_uints, hn::Lt(ids - hn::Set(narrow_uints, question.first_passed),
                                            hn::Set(narrow_uints, question.passed_count)));
    }

    [[nodiscard]] HWY_INLINE NarrowFloats row(uint32_t r) const {
        return hn::LoadU(narrow_floats, reinterpret_cast<const float *>(words_ + r * count_ + first_));
    }

    /// One coordinate of the corners.
    struct Corners {
        NarrowFloats a, b, c;
    };
    [[nodiscard]] HWY_INLINE Corners corners(uint32_t axis) const {
        const auto *const a = reinterpret_cast<const float *>(words_) + (axis * count_ + first_);
        const size_t stride = size_t{3} * count_;
        return {hn::LoadU(narrow_floats, a), hn::LoadU(narrow_floats, a + stride),
                hn::LoadU(narrow_floats, a + 2 * stride)};
    }

    [[nodiscard]] HWY_INLINE uint32_t id(uint32_t lane) const { return words_[9 * count_ + first_ + lane]; }

    /// The definition: see intersect.hpp.
    [[nodiscard]] HWY_INLINE float exact(uint32_t lane, const Point3 &org, const Point3 &dir) const {
        const TriangleSetup triangle(words_, count_, first_ + lane);
        const float from[3] = {org.x, org.y, org.z}, along[3] = {dir.x, dir.y, dir.z};
        return exact_distance(from, along, triangle.corners);
    }

    /// The same where the ray is certainly inside.
    [[nodiscard]] HWY_INLINE float distance(uint32_t lane, const Point3 &org, const Point3 &dir) const {
        const TriangleSetup triangle(words_, count_, first_ + lane);
        const ExactPlane plane(triangle);
        const double offset = plane.offset(triangle, org);
        const Point3 n = plane.n.rounded();
        const float det = (n.x * dir.x + n.y * dir.y) + n.z * dir.z;
        if (!(magnitude(det) < least_slope * sum_abs(n) * max_abs(dir))) return static_cast<float>(offset) / det;
        return static_cast<float>(
            offset / ((plane.n.x * double(dir.x) + plane.n.y * double(dir.y)) + plane.n.z * double(dir.z)));
    }

    /// Lowers best_t and sets best_id where one of the possible lanes' triangles is nearer, or as near with a lower id;
    /// where any hit will do, the first one does. Returns whether there was one. `distance_of` knows how far the
    /// triangles of certain lanes are.
    template <bool any_hit, typename DistanceOf>
    HWY_INLINE bool settle(uint32_t possible, uint32_t certain, const Point3 &org, const Point3 &dir, uint32_t left,
                           float &best_t, uint32_t &best_id, DistanceOf &&distance_of) const {
        bool hit = false;
        for (; possible != 0; possible &= possible - 1) {
            const uint32_t lane = lowest_bit(possible);
            if (id(lane) == left) continue;
            const float t = (certain >> lane & 1) != 0 ? distance_of(lane) : exact(lane, org, dir);
            if (!(t > 0.0f && (t < best_t || (!any_hit && t == best_t && id(lane) < best_id)))) continue;
            best_t = t;
            best_id = id(lane);
            if (any_hit) return true;
            hit = true;
        }
        return hit;
    }

private:
    const uint32_t *words_;
    uint32_t count_, first_;
};

/// A ray as it meets a leaf's triangles: in coordinates in which it runs along z, the axis that it mostly follows, and
/// z stays what it is (Woop, Benthin & Wald 2013, "Watertight ray/triangle intersection"). There the signs of
///     U = C x B,  V = A x C,  W = B x A
/// of the corners, seen from the origin, say on which sides of the edges it passes.
///
/// The error, by counting every rounding, with eps = 2^-24, r the largest coordinate of a corner seen from the origin,
/// and m that of the corners in the new x and y: the corners there are off by 6 eps r + eps m, U, V and W by
/// eps m (24 r + 8 m). With f the farthest corner along z, r is f + m at most.
struct LeafRay {
    Point3 org, dir;
    uint32_t left;          ///< the triangle that is passed
    uint32_t z;             ///< an axis of the world's; x and y are the others in their order
    float slope_x, slope_y; ///< how far it goes along x and y for one step along z
    float along;            ///< z of its direction

    static constexpr float error = 28 * 0x1p-24f; ///< times m (f + 2 m)

    [[nodiscard]] HWY_INLINE uint32_t x() const { return z == 0 ? 1 : 0; }
    [[nodiscard]] HWY_INLINE uint32_t y() const { return z == 2 ? 1 : 2; }
};

HWY_INLINE LeafRay leaf_ray(const Point3 &org, const Point3 &dir, uint32_t left) {
    LeafRay ray;
    ray.org = org;
    ray.dir = dir;
    ray.left = left;
    const float along_x = magnitude(dir.x), along_y = magnitude(dir.y), along_z = magnitude(dir.z);
    ray.z = along_x >= along_y && along_x >= along_z ? 0 : along_y >= along_z ? 1 : 2;
    const float components[3] = {dir.x, dir.y, dir.z};
    ray.along = components[ray.z];
    ray.slope_x = components[ray.x()] / components[ray.z];
    ray.slope_y = components[ray.y()] / components[ray.z];
    return ray;
}

/// On which sides of a triangle's edges a ray passes, a triangle a lane, up to an error less than the margin.
class LeafVerdict {
public:
    HWY_INLINE LeafVerdict(NarrowFloats u, NarrowFloats v, NarrowFloats w, NarrowFloats margin)
        : least_(hn::Min(hn::Min(u, v), w)), greatest_(hn::Max(hn::Max(u, v), w)), margin_(margin) {}

    /// Certainly missed.
    [[nodiscard]] HWY_INLINE uint32_t outside() const {
        return bits_of(narrow_floats, hn::And(hn::Gt(greatest_, margin_), hn::Lt(least_, hn::Neg(margin_))));
    }
    /// Certainly met, and not edge on.
    [[nodiscard]] HWY_INLINE uint32_t certain() const {
        return bits_of(narrow_floats, hn::Or(hn::Gt(least_, margin_), hn::Lt(greatest_, hn::Neg(margin_))));
    }

private:
    NarrowFloats least_, greatest_, margin_;
};

/// Its highest bit alone.
HWY_INLINE NarrowFloats sign_of(NarrowFloats x) {
    return hn::And(x, narrow_splat(-0.0f));
}

HWY_INLINE NarrowFloats abs_max(NarrowFloats x, NarrowFloats y, NarrowFloats z) {
    return hn::Max(hn::Max(hn::Abs(x), hn::Abs(y)), hn::Abs(z));
}

/// A leaf's triangles in a ray's own space.
class LeafInRaySpace {
public:
    HWY_INLINE LeafInRaySpace(const LeafLanes &leaf, const LeafRay &ray)
        : z_(seen(leaf, ray, ray.z)), along_(ray.along) {
        const auto sheared = [&](uint32_t axis, float slope) {
            const LeafLanes::Corners corners = seen(leaf, ray, axis);
            const auto by = narrow_splat(slope);
            return LeafLanes::Corners{hn::NegMulAdd(by, z_.a, corners.a), hn::NegMulAdd(by, z_.b, corners.b),
                                      hn::NegMulAdd(by, z_.c, corners.c)};
        };
        const LeafLanes::Corners x = sheared(ray.x(), ray.slope_x), y = sheared(ray.y(), ray.slope_y);
        m_ = hn::Max(hn::Max(hn::Max(hn::Abs(x.a), hn::Abs(y.a)), hn::Max(hn::Abs(x.b), hn::Abs(y.b))),
                     hn::Max(hn::Abs(x.c), hn::Abs(y.c)));
        f_ = hn::Max(hn::Max(hn::Abs(z_.a), hn::Abs(z_.b)), hn::Abs(z_.c));
        u_ = hn::MulSub(x.c, y.b, y.c * x.b);
        v_ = hn::MulSub(x.a, y.c, y.a * x.c);
        w_ = hn::MulSub(x.b, y.a, y.b * x.a);
        margin_ = hn::MulAdd(m_, narrow_splat(LeafRay::error) * (f_ + (m_ + m_)), narrow_splat(least_margin));
    }

    [[nodiscard]] HWY_INLINE LeafVerdict verdict() const { return {u_, v_, w_, margin_}; }

    /// Of triangles that may be met: those that certainly lie behind the origin. They are met at depth
    ///     z = (U Az + V Bz + W Cz) / (U + V + W),
    /// whose numerator is off by 3 times the margin times f, and 18 eps f m^2 for its own roundings, and whose
    /// denominator by 3 times the margin and 10 eps m^2. The margin is 56 eps m^2 at least. What is seen edge on has
    /// its depth from somewhere else (edge_on_depth()), and a denominator of less than 2^-23 (f^2 + m^2).
    [[nodiscard]] HWY_INLINE uint32_t behind() const {
        const auto numerator = hn::MulAdd(u_, z_.a, hn::MulAdd(v_, z_.b, w_ * z_.c)), denominator = (u_ + v_) + w_;
        const auto off = narrow_splat(4.0f) * margin_;
        const auto edge_on = narrow_splat(0x1p-23f) * hn::MulAdd(f_, f_, m_ * m_);
        // Positive behind the origin, since z goes from the corners to it.
        const auto way_back = hn::Xor(numerator, sign_of(hn::Xor(denominator, narrow_splat(along_))));
        const auto enough = hn::MulAdd(off, f_, narrow_splat(least_margin));
        return bits_of(narrow_floats, hn::And(hn::Gt(way_back, enough), hn::Gt(hn::Abs(denominator), off + edge_on)));
    }

private:
    /// From the corners to the origin.
    static HWY_INLINE LeafLanes::Corners seen(const LeafLanes &leaf, const LeafRay &ray, uint32_t axis) {
        const float org[3] = {ray.org.x, ray.org.y, ray.org.z};
        const LeafLanes::Corners corners = leaf.corners(axis);
        const auto from = narrow_splat(org[axis]);
        return {from - corners.a, from - corners.b, from - corners.c};
    }

    LeafLanes::Corners z_;
    /// As LeafRay has them.
    NarrowFloats m_ = hn::Zero(narrow_floats), f_ = m_, u_ = m_, v_ = m_, w_ = m_, margin_ = m_;
    float along_; ///< z of the ray's direction
};

/// One ray against the triangles of a leaf. Lowers best_t and sets best_id where something nearer is hit, or as near
/// with a lower id; where any hit will do, stops at the first. Returns whether there was one.
template <bool any_hit> HWY_NOINLINE bool hit_leaf(const TraceQuestion &question, uint32_t first_reference,
                                                   uint32_t count, const LeafRay &ray, float &best_t,
                                                   uint32_t &best_id) {
    const uint32_t *words = question.geometry.leaf_words + words_per_reference * size_t{first_reference};
    bool hit = false;
    for (uint32_t first = 0; first < count; first += narrow_lanes) {
        const LeafLanes leaf(words, count, first);
        const LeafInRaySpace seen(leaf, ray);
        const LeafVerdict verdict = seen.verdict();
        uint32_t possible = leaf.valid() & ~verdict.outside();
        if (possible == 0) continue;
        // Most often that is the triangle that the ray comes from.
        possible &= ~seen.behind();
        if (possible == 0) continue;
        if constexpr (any_hit) possible &= ~leaf.passed_by(question);
        hit |= leaf.template settle<any_hit>(possible, verdict.certain(), ray.org, ray.dir, ray.left, best_t, best_id,
                                             [&](uint32_t lane) { return leaf.distance(lane, ray.org, ray.dir); });
        if (any_hit && hit) return true;
    }
    return hit;
}

} // namespace glint::HWY_NAMESPACE
