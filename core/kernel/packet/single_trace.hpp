// One ray against the kd-tree, several triangles of a leaf at once: for rays that go their own way.
#pragma once

#include "kernel/packet/group_trace.hpp"

namespace glint::HWY_NAMESPACE {

/// As PreparedRay, without what only the scalar intersection needs.
struct SingleRay {
    float org[3], dir[3];
    float inverse_dir[3];     ///< finite: components too small to matter are made tiny instead of zero
    float parameter_slack[3]; ///< slack as a difference of t, along each axis
    float dir_reach, reach;   ///< largest coordinate of the direction; of the way to any corner

    HWY_INLINE SingleRay(const Point3 &o, const Point3 &d, const Box &scene_bounds)
        : org{o.x, o.y, o.z}, dir{d.x, d.y, d.z} {
        dir_reach = larger(larger(magnitude(d.x), magnitude(d.y)), magnitude(d.z));
        reach = reach_of(scene_bounds, o);
        const float slack = 0x1p-20f * reach, tiny = 1e-15f * dir_reach;
        for (int axis = 0; axis < 3; ++axis) {
            const float a = dir[axis];
            inverse_dir[axis] = 1.0f / (magnitude(a) < tiny ? __builtin_copysignf(tiny, a) : a);
            parameter_slack[axis] = slack * magnitude(inverse_dir[axis]);
        }
    }
};

#ifdef COUNTING
#define SCOUNT(i) (++glint_counts[any_hit ? 1 : 0][8 + i])
#else
#define SCOUNT(i) ((void)0)
#endif
template <bool any_hit> class SingleTrace {
public:
    HWY_INLINE SingleTrace(const TraceQuestion &question, RayGroup &rays, uint32_t number, const Point3 &org)
        : question_(question),
          ray_(org, {rays.dir_x[number], rays.dir_y[number], rays.dir_z[number]}, question.geometry.bounds),
          left_(rays.left[number]),
          best_t_(rays.t[number]),
          best_id_(rays.triangle_id[number]),
          org_(splat(org)),
          dir_(splat({ray_.dir[0], ray_.dir[1], ray_.dir[2]})) {}

    /// True when something was hit; the closest hit is then in t() and triangle_id().
    HWY_INLINE bool run() {
        const GeometryView &geometry = question_.geometry;
        SCOUNT(0);
        float t_near = 0.0f, t_far = best_t_ + distance_error * best_t_;
        for (int axis = 0; axis < 3; ++axis) {
            const float lo = axis == 0 ? geometry.bounds.lo.x : axis == 1 ? geometry.bounds.lo.y : geometry.bounds.lo.z;
            const float hi = axis == 0 ? geometry.bounds.hi.x : axis == 1 ? geometry.bounds.hi.y : geometry.bounds.hi.z;
            const float t_lo = (lo - ray_.org[axis]) * ray_.inverse_dir[axis];
            const float t_hi = (hi - ray_.org[axis]) * ray_.inverse_dir[axis];
            t_near = larger(t_near, smaller(t_lo, t_hi) - ray_.parameter_slack[axis]);
            t_far = smaller(t_far, larger(t_lo, t_hi) + ray_.parameter_slack[axis]);
        }
        if (t_near > t_far) return false;

        struct Pending {
            uint32_t node;
            float t_near, t_far;
        };
        Pending stack[max_tree_depth];
        int pending = 0;
        uint32_t index = 0;
        while (true) {
            const KdNode node = geometry.nodes[index];
            SCOUNT(1);
            if (!node.is_leaf()) {
                const uint32_t axis = node.axis();
                const float t_split = (node.split() - ray_.org[axis]) * ray_.inverse_dir[axis];
                const bool upward = ray_.inverse_dir[axis] > 0.0f;
                const uint32_t first = upward ? index + 1 : node.upper_child();
                const uint32_t second = upward ? node.upper_child() : index + 1;
                const float t_second = t_split - ray_.parameter_slack[axis];
                const float t_first = t_split + ray_.parameter_slack[axis];
                if (t_second > t_far) {
                    index = first;
                } else if (t_first < t_near) {
                    index = second;
                } else {
                    __builtin_prefetch(geometry.nodes + second);
                    stack[pending++] = {second, larger(t_second, t_near), t_far};
                    index = first;
                    t_far = smaller(t_first, t_far);
                }
                continue;
            }
            if (visit_leaf(node) && any_hit) return true;
            do {
                if (pending == 0) return hit_;
                --pending;
            } while (stack[pending].t_near > best_t_ + distance_error * best_t_);
            index = stack[pending].node;
            t_near = stack[pending].t_near;
            t_far = stack[pending].t_far;
        }
    }

    [[nodiscard]] HWY_INLINE float t() const { return best_t_; }
    [[nodiscard]] HWY_INLINE uint32_t triangle_id() const { return best_id_; }

private:
    HWY_INLINE bool visit_leaf(const KdNode &node) {
        const uint32_t count = node.reference_count();
        SCOUNT(5); if (count) SCOUNT(6);
        const uint32_t *words = question_.geometry.leaf_words + words_per_reference * size_t{node.first_reference()};
        for (uint32_t first = 0; first < count; first += lane_count) {
            const uint32_t valid = count - first >= lane_count ? all_lanes : (1u << (count - first)) - 1;
            SCOUNT(2);
            const FilterResult result = filter(words, count, first);
            uint32_t possible = bits_of(result.possible) & valid;
            const uint32_t certain = bits_of(result.certain);
            for (; possible != 0; possible &= possible - 1) {
                const uint32_t lane = lowest_bit(possible);
                accept(words, count, first + lane, (certain >> lane & 1) != 0);
            }
            if (any_hit && hit_) return true;
        }
        return hit_;
    }

    HWY_INLINE FilterResult filter(const uint32_t *words, uint32_t count, uint32_t first) const {
        const auto row = [&](uint32_t r) { return hn::BitCast(floats, hn::LoadU(uints, words + r * count + first)); };
        const Points a = {row(0), row(1), row(2)};
        const Points e1 = {row(3) - a.x, row(4) - a.y, row(5) - a.z};
        const Points e2 = {row(6) - a.x, row(7) - a.y, row(8) - a.z};
        const Points s = {org_.x - a.x, org_.y - a.y, org_.z - a.z};
        const Points q = {dir_.y * s.z - dir_.z * s.y, dir_.z * s.x - dir_.x * s.z, dir_.x * s.y - dir_.y * s.x};
        const Points n = {e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z, e1.x * e2.y - e1.y * e2.x};
        const Floats e = hn::Max(max3(hn::Abs(e1.x), hn::Abs(e1.y), hn::Abs(e1.z)),
                                 max3(hn::Abs(e2.x), hn::Abs(e2.y), hn::Abs(e2.z)));
        const Floats margin = splat(from_anywhere_error * ray_.dir_reach) * e * (splat(ray_.reach) + (e + e)) +
                              (splat(from_anywhere_cross_error) * e * sum_abs(q) + splat(least_margin));
        return judge(dot(n, dir_), dot(e2, q), hn::Neg(dot(e1, q)), margin);
    }

    HWY_INLINE void accept(const uint32_t *words, uint32_t count, uint32_t i, bool certain) {
        SCOUNT(3);
        if (!certain) SCOUNT(4);
        const uint32_t id = words[9 * count + i];
        if (id == left_) return;
        if (any_hit && id - question_.first_passed < question_.passed_count) return;
        const TriangleSetup triangle(words, count, i);
        float t = 0.0f;
        if (certain) {
            const ExactPlane plane(triangle);
            const Point3 n = plane.n.rounded();
            const float det = (n.x * ray_.dir[0] + n.y * ray_.dir[1]) + n.z * ray_.dir[2];
            certain = !(magnitude(det) < least_slope * sum_abs(n) * ray_.dir_reach);
            t = static_cast<float>(plane.offset(triangle, {ray_.org[0], ray_.org[1], ray_.org[2]})) / det;
        }
        if (!certain) t = exact_distance(ray_.org, ray_.dir, triangle.corners);
        if (!(t > 0.0f)) return;
        if (t < best_t_ || (!any_hit && t == best_t_ && id < best_id_)) {
            best_t_ = t;
            best_id_ = id;
            hit_ = true;
        }
    }

    const TraceQuestion &question_;
    SingleRay ray_;
    uint32_t left_;
    float best_t_;
    uint32_t best_id_;
    bool hit_ = false;
    Points org_, dir_;
};

} // namespace glint::HWY_NAMESPACE
