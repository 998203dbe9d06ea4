// Up to 16 rays that go through the kd-tree in step, each with its own interval: for blocks whose rays are too far
// apart for a beam, but still meet many of the same nodes (Wald et al. 2001, "Interactive rendering with coherent ray
// tracing").
#pragma once

#include "kernel/packet/single_trace.hpp"

namespace glint::HWY_NAMESPACE {

template <bool any_hit> class BlockTrace {
public:
    HWY_INLINE BlockTrace(const TraceQuestion &question, RayGroup &rays, uint32_t block)
        : question_(question), rays_(rays), first_ray_(block * block_size) {}

    /// Traces those rays of the block that `bits` names, whose directions must agree in all signs. Returns which of
    /// them were hit.
    HWY_INLINE uint32_t run(uint32_t bits) {
        const GeometryView &geometry = question_.geometry;
        hits_ = 0;
        prepare(bits);
        int pending = 0;
        Step now = first_step();
        if (now.active(*this) == 0) return 0;
        while (true) {
            const KdNode node = geometry.nodes[now.node];
            if (!node.is_leaf()) {
                const uint32_t axis = node.axis();
                const uint32_t first = upward_[axis] ? now.node + 1 : node.upper_child();
                const uint32_t second = upward_[axis] ? node.upper_child() : now.node + 1;
                Step &later = stack_[pending];
                uint32_t enters_first = 0, enters_second = 0;
                for (uint32_t part = 0; part < block_size; part += lane_count) {
                    const Floats near_part = hn::Load(floats, now.near + part),
                                 far_part = hn::Load(floats, now.far + part);
                    const Floats t_split =
                        (splat(node.split()) - org(axis, part)) * hn::Load(floats, inverse_[axis] + part);
                    const Floats slack = hn::Load(floats, slack_[axis] + part);
                    const Floats first_far = hn::Min(far_part, t_split + slack);
                    const Floats second_near = hn::Max(near_part, t_split - slack);
                    enters_first |= bits_of(hn::Le(near_part, first_far));
                    enters_second |= bits_of(hn::Le(second_near, far_part));
                    hn::Store(second_near, floats, later.near + part);
                    hn::Store(far_part, floats, later.far + part);
                    hn::Store(first_far, floats, first_far_ + part);
                }
                if (enters_first == 0) {
                    now.node = second;
                    continue; // every ray was in the second cell already
                }
                if (enters_second != 0) {
                    __builtin_prefetch(geometry.nodes + second);
                    later.node = second;
                    ++pending;
                    for (uint32_t part = 0; part < block_size; part += lane_count) {
                        hn::Store(hn::Load(floats, first_far_ + part), floats, now.far + part);
                    }
                }
                now.node = first;
                continue;
            }
            if (node.reference_count() > 0) visit_leaf(node, now.active(*this));
            if (any_hit && hits_ == bits) return hits_;
            do {
                if (pending == 0) return hits_;
                --pending;
            } while (stack_[pending].active(*this) == 0);
            now = stack_[pending];
        }
    }

private:
    /// A node, and each ray's interval there: empty for rays that do not enter it.
    struct alignas(64) Step {
        float near[block_size], far[block_size];
        uint32_t node;

        HWY_INLINE uint32_t active(const BlockTrace &trace) const {
            uint32_t bits = 0;
            for (uint32_t part = 0; part < block_size; part += lane_count) {
                const Floats near_part = hn::Load(floats, near + part);
                const Floats end = hn::Min(hn::Load(floats, far + part), hn::Load(floats, trace.end_ + part));
                bits |= bits_of(hn::Le(near_part, end)) << part;
            }
            return bits;
        }
    };

    [[nodiscard]] HWY_INLINE Floats org(uint32_t axis, uint32_t part) const {
        return hn::Load(floats, rays_.org_row(static_cast<int>(axis)) + first_ray_ + part);
    }

    /// What PreparedRay has for walking the tree, for every lane.
    HWY_INLINE void prepare(uint32_t bits) {
        const Box &box = question_.geometry.bounds;
        const uint32_t first = first_ray_ + lowest_bit(bits);
        for (uint32_t part = 0; part < block_size; part += lane_count) {
            const Points dir = rays_.dir(first_ray_ + part);
            const Points o = {org(0, part), org(1, part), org(2, part)};
            const Points to_lo = {splat(box.lo.x) - o.x, splat(box.lo.y) - o.y, splat(box.lo.z) - o.z};
            const Points to_hi = {splat(box.hi.x) - o.x, splat(box.hi.y) - o.y, splat(box.hi.z) - o.z};
            const FloatMask lanes = mask_of((bits >> part) & all_lanes);
            const Floats largest = max_abs(dir), reach = hn::Max(max_abs(to_lo), max_abs(to_hi));
            const Floats slack = splat(slack_of_extent) * reach, tiny = splat(1e-15f) * largest;
            const Floats components[3] = {dir.x, dir.y, dir.z};
            for (uint32_t axis = 0; axis < 3; ++axis) {
                const Floats d = hn::IfThenElse(hn::Lt(hn::Abs(components[axis]), tiny),
                                                hn::CopySign(tiny, components[axis]), components[axis]);
                const Floats inverse = splat(1.0f) / d;
                hn::Store(inverse, floats, inverse_[axis] + part);
                hn::Store(slack * hn::Abs(inverse), floats, slack_[axis] + part);
            }
            const Floats t = hn::Load(floats, rays_.t + first_ray_ + part);
            hn::Store(hn::IfThenElse(lanes, t + splat(distance_error) * t, splat(-1.0f)), floats, end_ + part);
        }
        upward_[0] = !__builtin_signbit(rays_.dir_x[first]);
        upward_[1] = !__builtin_signbit(rays_.dir_y[first]);
        upward_[2] = !__builtin_signbit(rays_.dir_z[first]);
    }

    /// Every ray's way through the scene's box.
    HWY_INLINE Step first_step() const {
        const Box &box = question_.geometry.bounds;
        const float lo[3] = {box.lo.x, box.lo.y, box.lo.z}, hi[3] = {box.hi.x, box.hi.y, box.hi.z};
        Step step;
        step.node = 0;
        for (uint32_t part = 0; part < block_size; part += lane_count) {
            Floats near_part = hn::Zero(floats), far_part = hn::Load(floats, end_ + part);
            for (uint32_t axis = 0; axis < 3; ++axis) {
                const Floats inverse = hn::Load(floats, inverse_[axis] + part),
                             slack = hn::Load(floats, slack_[axis] + part);
                const Floats t_lo = (splat(lo[axis]) - org(axis, part)) * inverse;
                const Floats t_hi = (splat(hi[axis]) - org(axis, part)) * inverse;
                near_part = hn::Max(near_part, hn::Min(t_lo, t_hi) - slack);
                far_part = hn::Min(far_part, hn::Max(t_lo, t_hi) + slack);
            }
            hn::Store(near_part, floats, step.near + part);
            hn::Store(far_part, floats, step.far + part);
        }
        return step;
    }

    HWY_INLINE void visit_leaf(const KdNode &node, uint32_t active) {
        for (; active != 0; active &= active - 1) {
            const uint32_t lane = lowest_bit(active), i = first_ray_ + lane;
            const Point3 o = {rays_.org_x[i], rays_.org_y[i], rays_.org_z[i]};
            const Point3 d = {rays_.dir_x[i], rays_.dir_y[i], rays_.dir_z[i]};
            float t = rays_.t[i];
            uint32_t id = rays_.triangle_id[i];
            const LeafRay ray = leaf_ray(o, d, rays_.left[i]);
            if (!hit_leaf<any_hit>(question_, node.first_reference(), node.reference_count(), ray, t, id)) continue;
            hits_ |= 1u << lane;
            if constexpr (any_hit) {
                end_[lane] = -1.0f;
            } else {
                rays_.t[i] = t;
                rays_.triangle_id[i] = id;
                end_[lane] = t + distance_error * t;
            }
        }
    }

    const TraceQuestion &question_;
    RayGroup &rays_;
    uint32_t first_ray_;
    uint32_t hits_ = 0;
    bool upward_[3];
    alignas(64) float inverse_[3][block_size];
    alignas(64) float slack_[3][block_size];
    alignas(64) float end_[block_size]; ///< how far a ray may still go; -1 for rays that are done
    alignas(64) float first_far_[block_size];
    Step stack_[max_tree_depth + 1];
};

/// Bit r for every ray of a block whose direction has the signs of ray `like`.
HWY_INLINE uint32_t rays_of_same_signs(const RayGroup &rays, uint32_t block, uint32_t like) {
    const Uints sign_bit = hn::Set(uints, 0x80000000u);
    uint32_t same = 0;
    for (uint32_t part = 0; part < block_size; part += lane_count) {
        const uint32_t ray = block * block_size + part;
        const auto differing = [&](const float *row) {
            const Uints bits = hn::BitCast(uints, hn::Load(floats, row + ray));
            return hn::And(hn::Xor(bits, hn::BitCast(uints, splat(row[like]))), sign_bit);
        };
        const Uints any = hn::Or(hn::Or(differing(rays.dir_x), differing(rays.dir_y)), differing(rays.dir_z));
        same |= bits_of(hn::RebindMask(floats, hn::Eq(any, hn::Zero(uints)))) << part;
    }
    return same;
}

} // namespace glint::HWY_NAMESPACE
