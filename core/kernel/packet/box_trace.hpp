// A group of rays through a hierarchy over boxes: a stack of boxes, with the rays that reach each.
#pragma once

#include "accel/box_tree.hpp"
#include "kernel/clip.hpp"
#include "kernel/packet/ray_group.hpp"

namespace glint::HWY_NAMESPACE {

class BoxTrace {
public:
    /// Of the selected rays; those that are deselected on the way end there. `wider` says how many times a ray's slack
    /// boxes are taken for larger by.
    HWY_INLINE BoxTrace(const Box &scene_bounds, const RayGroup &rays, const RaySelection &selection,
                        bool shares_origin, float wider)
        : rays_(rays), selection_(selection), shares_origin_(shares_origin) {
        prepare(scene_bounds, wider);
    }

    /// Calls visit(i, rays) for every place i in the order of the boxes, with the rays that reach that box, near ones
    /// first as the first of those rays sees it: what is hit there hides what is behind.
    template <typename Visit> HWY_INLINE void walk(const BoxNode *nodes, Visit &&visit) {
        uint32_t pending = 0;
        stack_[pending++] = {0, selection_};
        while (pending > 0) {
            const Pending now = stack_[--pending];
            const BoxNode &node = nodes[now.node];
            const RaySelection reach = rays_that_reach(node.bounds, now.rays);
            if (reach.empty()) continue;
            if (node.count == 0) {
                const uint32_t ray = first_ray_of(reach);
                const Box &first = nodes[node.first].bounds, &second = nodes[node.first + 1].bounds;
                const uint32_t near =
                    is_second_nearer(first, second, rays_.dir_x[ray], rays_.dir_y[ray], rays_.dir_z[ray]) ? 1 : 0;
                stack_[pending++] = {node.first + 1 - near, reach};
                stack_[pending++] = {node.first + near, reach};
                continue;
            }
            visit(node.first, reach);
        }
    }

    /// clip_to_box() for many rays; those that ended are left out.
    [[nodiscard]] HWY_NOINLINE RaySelection rays_that_reach(const Box &box, const RaySelection &candidates) const {
        RaySelection reach{};
        for_each_vector(candidates, [&](uint32_t ray, uint32_t lanes) {
            lanes &= selection_.lanes(ray);
            const Floats slack = hn::Load(floats, slack_ + ray);
            const Floats t = hn::Load(floats, rays_.t + ray);
            Floats near = hn::Zero(floats), far = t + splat(distance_error) * t;
            const auto clip = [&](const float *inverse_row, Floats o, float lo, float hi) {
                const Floats inverse = hn::Load(floats, inverse_row + ray);
                const Floats t_lo = (splat(lo) - o) * inverse, t_hi = (splat(hi) - o) * inverse;
                const Floats room = slack * hn::Abs(inverse);
                near = hn::Max(near, hn::Min(t_lo, t_hi) - room);
                far = hn::Min(far, hn::Max(t_lo, t_hi) + room);
            };
            const Points o = org(ray);
            clip(inverse_[0], o.x, box.lo.x, box.hi.x);
            clip(inverse_[1], o.y, box.lo.y, box.hi.y);
            clip(inverse_[2], o.z, box.lo.z, box.hi.z);
            reach.add(ray, ~bits_of(hn::Gt(near, far)) & lanes);
        });
        return reach;
    }

private:
    struct Pending {
        uint32_t node;
        RaySelection rays;
    };

    [[nodiscard]] HWY_INLINE Points org(uint32_t ray) const {
        return shares_origin_ ? splat(rays_.shared_origin) : rays_.org(ray);
    }

    /// What PreparedRay works out for a ray.
    HWY_NOINLINE void prepare(const Box &bounds, float wider) {
        for_each_vector(selection_, [&](uint32_t ray, uint32_t) {
            const Points o = org(ray), dir = rays_.dir(ray);
            const Points lo = difference({splat(bounds.lo.x), splat(bounds.lo.y), splat(bounds.lo.z)}, o);
            const Points hi = difference({splat(bounds.hi.x), splat(bounds.hi.y), splat(bounds.hi.z)}, o);
            hn::Store(splat(wider * slack_of_extent) * hn::Max(max_abs(lo), max_abs(hi)), floats, slack_ + ray);
            const Floats tiny = splat(1e-15f) * max_abs(dir);
            const auto inverse = [&](Floats d) {
                return splat(1.0f) / hn::IfThenElse(hn::Lt(hn::Abs(d), tiny), hn::CopySign(tiny, d), d);
            };
            hn::Store(inverse(dir.x), floats, inverse_[0] + ray);
            hn::Store(inverse(dir.y), floats, inverse_[1] + ray);
            hn::Store(inverse(dir.z), floats, inverse_[2] + ray);
        });
    }

    const RayGroup &rays_;
    const RaySelection &selection_;
    bool shares_origin_;
    alignas(64) float slack_[group_size];
    alignas(64) float inverse_[3][group_size];
    Pending stack_[max_box_tree_depth + 1];
};

} // namespace glint::HWY_NAMESPACE
