// A group of rays through a scene's quadrics: a stack of boxes, with the rays that reach each.
#pragma once

#include "kernel/packet/group_test.hpp"
#include "kernel/packet/quadric_test.hpp"

namespace glint::HWY_NAMESPACE {

template <bool any_hit> class QuadricTrace {
public:
    /// As GroupTest: of the selected rays those that are hit are deselected where any hit will do.
    HWY_INLINE QuadricTrace(const TraceQuestion &question, RayGroup &rays, RaySelection &selection, bool shares_origin)
        : question_(question),
          quadrics_(question.geometry.quadrics),
          rays_(rays),
          selection_(selection),
          shares_origin_(shares_origin) {}

    HWY_INLINE void run() {
        for (uint32_t i = 0; i < quadrics_.unbounded_count; ++i) test(quadrics_.all[i], selection_);
        if (quadrics_.count == quadrics_.unbounded_count) return;
        prepare();
        uint32_t pending = 0;
        stack_[pending++] = {0, selection_};
        while (pending > 0) {
            const Pending now = stack_[--pending];
            const QuadricNode &node = quadrics_.nodes[now.node];
            const RaySelection reach = rays_that_reach(node.bounds, now.rays);
            if (reach.empty()) continue;
            if (node.count == 0) {
                stack_[pending++] = {node.first + 1, reach};
                stack_[pending++] = {node.first, reach};
                continue;
            }
            for (uint32_t i = node.first; i < node.first + node.count; ++i) test(quadrics_.all[i], reach);
        }
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
    HWY_INLINE void prepare() {
        const Box &bounds = question_.geometry.bounds;
        for_each_vector(selection_, [&](uint32_t ray, uint32_t) {
            const Points o = org(ray), dir = rays_.dir(ray);
            const Points lo = difference({splat(bounds.lo.x), splat(bounds.lo.y), splat(bounds.lo.z)}, o);
            const Points hi = difference({splat(bounds.hi.x), splat(bounds.hi.y), splat(bounds.hi.z)}, o);
            hn::Store(splat(slack_of_extent) * hn::Max(max_abs(lo), max_abs(hi)), floats, slack_ + ray);
            const Floats tiny = splat(1e-15f) * max_abs(dir);
            const auto inverse = [&](Floats d) {
                return splat(1.0f) / hn::IfThenElse(hn::Lt(hn::Abs(d), tiny), hn::CopySign(tiny, d), d);
            };
            hn::Store(inverse(dir.x), floats, inverse_[0] + ray);
            hn::Store(inverse(dir.y), floats, inverse_[1] + ray);
            hn::Store(inverse(dir.z), floats, inverse_[2] + ray);
        });
    }

    /// clip_to_box() for many rays; those that any hit ended are left out.
    [[nodiscard]] HWY_INLINE RaySelection rays_that_reach(const Box &box, const RaySelection &candidates) const {
        RaySelection reach{};
        for_each_vector(candidates, [&](uint32_t ray, uint32_t lanes) {
            if constexpr (any_hit) lanes &= selection_.lanes(ray);
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

    HWY_NOINLINE void test(const PlacedQuadric &quadric, const RaySelection &candidates) {
        if (any_hit && quadric.id - question_.first_passed < question_.passed_count) return;
        const Uints id = hn::Set(uints, quadric.id);
        for_each_vector(candidates, [&](uint32_t ray, uint32_t lanes) {
            if constexpr (any_hit) {
                lanes &= selection_.lanes(ray);
                if (lanes == 0) return;
            }
            const Floats distance = quadric_distances(quadric, promote(org(ray)), promote(rays_.dir(ray)));
            const Floats best = hn::Load(floats, rays_.t + ray);
            FloatMask is_nearer = hn::Lt(distance, best);
            if constexpr (!any_hit) {
                const Uints best_id = hn::Load(uints, rays_.triangle_id + ray);
                is_nearer =
                    hn::Or(is_nearer, hn::And(hn::Eq(distance, best), hn::RebindMask(floats, hn::Lt(id, best_id))));
            }
            const FloatMask hit = hn::And(is_nearer, hn::Gt(distance, hn::Zero(floats)));
            const uint32_t hit_lanes = bits_of(hit) & lanes;
            if (hit_lanes == 0) return;
            if constexpr (any_hit) {
                selection_.remove(ray, hit_lanes);
            } else {
                const FloatMask counts = mask_of(hit_lanes);
                hn::Store(hn::IfThenElse(counts, distance, best), floats, rays_.t + ray);
                const Uints old = hn::Load(uints, rays_.triangle_id + ray);
                hn::Store(hn::IfThenElse(hn::RebindMask(uints, counts), id, old), uints, rays_.triangle_id + ray);
            }
        });
    }

    const TraceQuestion &question_;
    const QuadricView &quadrics_;
    RayGroup &rays_;
    RaySelection &selection_;
    bool shares_origin_;
    alignas(64) float slack_[group_size];
    alignas(64) float inverse_[3][group_size];
    Pending stack_[max_quadric_tree_depth + 1];
};

/// The selected rays against the scene's quadrics, once they have met its triangles.
template <bool any_hit> HWY_NOINLINE void trace_quadrics(const TraceQuestion &question, RayGroup &rays,
                                                         RaySelection &selection, bool shares_origin) {
    if (selection.empty()) return;
    QuadricTrace<any_hit>(question, rays, selection, shares_origin).run();
}

} // namespace glint::HWY_NAMESPACE
