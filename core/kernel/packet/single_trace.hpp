// One ray against the kd-tree, several triangles of a leaf at once: for rays that go their own way.
#pragma once

#include "kernel/packet/leaf_test.hpp"

namespace glint::HWY_NAMESPACE {

/// As PreparedRay, without what only the scalar intersection needs.
struct SingleRay {
    float org[3], dir[3];
    float inverse_dir[3];     ///< finite: components too small to matter are made tiny instead of zero
    float parameter_slack[3]; ///< slack as a difference of t, along each axis

    HWY_INLINE SingleRay(const Point3 &o, const Point3 &d, const Box &scene_bounds)
        : org{o.x, o.y, o.z}, dir{d.x, d.y, d.z} {
        const float slack = 0x1p-20f * reach_of(scene_bounds, o), tiny = 1e-15f * max_abs(d);
        for (int axis = 0; axis < 3; ++axis) {
            const float a = dir[axis];
            inverse_dir[axis] = 1.0f / (magnitude(a) < tiny ? __builtin_copysignf(tiny, a) : a);
            parameter_slack[axis] = slack * magnitude(inverse_dir[axis]);
        }
    }
};

template <bool any_hit> class SingleTrace {
public:
    HWY_INLINE SingleTrace(const TraceQuestion &question, RayGroup &rays, uint32_t number, const Point3 &org)
        : question_(question),
          ray_(org, {rays.dir_x[number], rays.dir_y[number], rays.dir_z[number]}, question.geometry.bounds),
          leaf_ray_(leaf_ray(org, {rays.dir_x[number], rays.dir_y[number], rays.dir_z[number]}, rays.left[number])),
          best_t_(rays.t[number]),
          best_id_(rays.triangle_id[number]) {}

    /// True when something was hit; the closest hit is then in t() and triangle_id().
    HWY_INLINE bool run() {
        const GeometryView &geometry = question_.geometry;
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
            if (hit_leaf<any_hit>(question_, node.first_reference(), node.reference_count(), leaf_ray_, best_t_,
                                  best_id_)) {
                if (any_hit) return true;
                hit_ = true;
            }
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
    const TraceQuestion &question_;
    SingleRay ray_;
    LeafRay leaf_ray_;
    float best_t_;
    uint32_t best_id_;
    bool hit_ = false;
};

} // namespace glint::HWY_NAMESPACE
