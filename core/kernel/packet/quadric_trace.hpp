// A group of rays through a scene's quadrics.
#pragma once

#include "kernel/packet/box_trace.hpp"
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
        BoxTrace boxes(question_.geometry.bounds, rays_, selection_, shares_origin_, 1.0f);
        boxes.walk(quadrics_.nodes, [&](uint32_t i, const RaySelection &reach) {
            test(quadrics_.all[quadrics_.unbounded_count + i], reach);
        });
    }

private:
    [[nodiscard]] HWY_INLINE Points org(uint32_t ray) const {
        return shares_origin_ ? splat(rays_.shared_origin) : rays_.org(ray);
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
};

/// The selected rays against the scene's quadrics, once they have met its triangles.
template <bool any_hit> HWY_NOINLINE void trace_quadrics(const TraceQuestion &question, RayGroup &rays,
                                                         RaySelection &selection, bool shares_origin) {
    if (selection.empty()) return;
    QuadricTrace<any_hit>(question, rays, selection, shares_origin).run();
}

} // namespace glint::HWY_NAMESPACE
