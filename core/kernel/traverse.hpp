// Rays through the kd-tree: one walk, from which closest hit and any hit are made.
#pragma once

#include <cstdint>

#include "accel/kd_tree.hpp"
#include "kernel/intersect.hpp"

namespace glint {

/// What is traced against. Plain pointers: shared by all kernels, owned by the Accel.
struct GeometryView {
    const KdNode *nodes; ///< nullptr: no tree, every ray meets every triangle
    const uint32_t *references;
    const TriangleCorners *corners;
    const TriangleSurface *surfaces;
    uint32_t triangle_count;
    Box bounds;
};

inline constexpr uint32_t no_triangle = UINT32_MAX;

struct Hit {
    float t;              ///< what hits are compared by
    uint32_t triangle_id; ///< no_triangle where nothing was hit
    double exact_t;       ///< what t was rounded from; for the hit point
};

/// The part of a ray, as [t_near, t_far], that lies in a box or within the ray's slack of it; empty where t_near >
/// t_far.
struct Interval {
    float t_near, t_far;
};

inline Interval clip_to_box(const PreparedRay &ray, const Box &box, float t_max) {
    Interval part{0.0f, t_max};
    for (int axis = 0; axis < 3; ++axis) {
        const float t_lo = (box.lo[axis] - ray.org[axis]) * ray.inverse_dir[axis];
        const float t_hi = (box.hi[axis] - ray.org[axis]) * ray.inverse_dir[axis];
        const float enter = (t_lo < t_hi ? t_lo : t_hi) - ray.parameter_slack[axis];
        const float leave = (t_lo < t_hi ? t_hi : t_lo) + ray.parameter_slack[axis];
        if (enter > part.t_near) part.t_near = enter;
        if (leave < part.t_far) part.t_far = leave;
    }
    return part;
}

/// Calls visit(triangle ids, count) for every leaf that the given part of the ray may reach before t_max, near leaves
/// first, until a call returns true. `visit` may lower t_max. Leaves within the ray's slack are visited too.
///
/// Correct because of this: where the exact ray meets a triangle at t, some leaf's cell holds that point and lists the
/// triangle, and each step below keeps t inside [t_near, t_far] on the way to that cell, whatever was rounded.
template <typename Visit>
void walk_tree(const GeometryView &geometry, const PreparedRay &ray, Interval part, const float &t_max, Visit &&visit) {
    auto [t_near, t_far] = part;
    if (t_near > t_far) return;

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
            const auto axis = static_cast<int>(node.axis());
            const float t_split = (node.split() - component(ray.org, axis)) * component(ray.inverse_dir, axis);
            const bool upward = component(ray.inverse_dir, axis) > 0.0f;
            const uint32_t first = upward ? index + 1 : node.upper_child();
            const uint32_t second = upward ? node.upper_child() : index + 1;
            const float t_second = t_split - component(ray.parameter_slack, axis); // the second cell begins no earlier
            const float t_first = t_split + component(ray.parameter_slack, axis);  // the first cell ends no later
            if (t_second > t_far) {
                index = first;
            } else if (t_first < t_near) {
                index = second;
            } else {
                stack[pending++] = {second, t_second > t_near ? t_second : t_near, t_far};
                index = first;
                if (t_first < t_far) t_far = t_first;
            }
            continue;
        }
        if (node.reference_count() > 0 && visit(geometry.references + node.first_reference(), node.reference_count())) {
            return;
        }
        do {
            if (pending == 0) return;
            --pending;
        } while (stack[pending].t_near > t_max);
        index = stack[pending].node;
        t_near = stack[pending].t_near;
        t_far = stack[pending].t_far;
    }
}

/// The nearest triangle with 0 < t <= t_max; of several at the same t, the one with the lowest id. A flat triangle
/// never meets a ray that leaves it, so `left_triangle` (or no_triangle) is passed over.
inline Hit closest_hit(const GeometryView &geometry, const PreparedRay &ray, float t_max,
                       uint32_t left_triangle = no_triangle) {
    Hit best{t_max, no_triangle, t_max};
    const auto test = [&](uint32_t triangle_id) {
        if (triangle_id == left_triangle) return;
        const double exact_t = intersect(ray, geometry.corners[triangle_id]);
        const auto t = static_cast<float>(exact_t);
        if (t > 0.0f && (t < best.t || (t == best.t && triangle_id < best.triangle_id))) {
            best = {t, triangle_id, exact_t};
        }
    };
    if (!geometry.nodes) {
        for (uint32_t id = 0; id < geometry.triangle_count; ++id) test(id);
        return best;
    }
    const Interval part = clip_to_box(ray, geometry.bounds, t_max);
    walk_tree(geometry, ray, part, best.t, [&](const uint32_t *triangle_ids, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) test(triangle_ids[i]);
        return false;
    });
    return best;
}

/// Whether any triangle that can_block(triangle_id) allows is met at 0 < t < t_max. Meant for shadow rays, which begin
/// and end within the scene and so need not be clipped to it.
template <typename CanBlock>
bool any_hit(const GeometryView &geometry, const PreparedRay &ray, float t_max, CanBlock &&can_block) {
    const auto blocks = [&](uint32_t triangle_id) {
        if (!can_block(triangle_id)) return false;
        const auto t = static_cast<float>(intersect(ray, geometry.corners[triangle_id]));
        return t > 0.0f && t < t_max;
    };
    if (!geometry.nodes) {
        for (uint32_t id = 0; id < geometry.triangle_count; ++id) {
            if (blocks(id)) return true;
        }
        return false;
    }
    bool blocked = false;
    walk_tree(geometry, ray, {0.0f, t_max}, t_max, [&](const uint32_t *triangle_ids, uint32_t count) {
        for (uint32_t i = 0; i < count && !blocked; ++i) blocked = blocks(triangle_ids[i]);
        return blocked;
    });
    return blocked;
}

} // namespace glint
