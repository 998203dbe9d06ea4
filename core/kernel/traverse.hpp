// Rays through the kd-tree: one walk, from which closest hit and any hit are made.
#pragma once

#include <cstdint>

#include <glint/ray_query.hpp>

#include "accel/bvh/wide_bvh.hpp"
#include "accel/kd_tree.hpp"
#include "kernel/clip.hpp"
#include "kernel/instance.hpp"
#include "kernel/intersect.hpp"
#include "kernel/quadric.hpp"

namespace glint {

/// What is traced against. Plain pointers: shared by all kernels, owned by the Accel.
struct GeometryView {
    const KdNode *nodes;             ///< of a kd-tree, or nullptr
    const WideNode *wide_nodes;      ///< of a bounding volume hierarchy, or nullptr
    const uint32_t *leaf_words;      ///< see leaf_triangles.hpp
    const TriangleSurface *surfaces; ///< by triangle_id
    uint32_t triangle_count;         ///< those of instances included, which no tree here holds
    QuadricView quadrics;
    InstanceView instances;
    Box bounds; ///< of all that has bounds

    /// Of what the instance is in its own space, as far as rays through its triangles ask.
    [[nodiscard]] static GeometryView inside(const Instance &instance) {
        GeometryView view{};
        view.nodes = instance.nodes;
        view.wide_nodes = instance.wide_nodes;
        view.leaf_words = instance.leaf_words;
        view.triangle_count = instance.triangle_count;
        view.bounds = instance.own_bounds;
        return view;
    }
};

struct Hit {
    float t;
    uint32_t triangle_id; ///< no_triangle where nothing was hit
};

/// Calls visit(leaf) for every leaf that the given part of the ray may reach before search_end(t_max), near leaves
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
        if (visit(LeafTriangles(geometry.leaf_words, node.first_reference(), node.reference_count()))) return;
        do {
            if (pending == 0) return;
            --pending;
        } while (stack[pending].t_near > search_end(t_max));
        index = stack[pending].node;
        t_near = stack[pending].t_near;
        t_far = stack[pending].t_far;
    }
}

/// The same for a bounding volume hierarchy. A triangle's hits lie in its box, so boxes are as good as cells.
template <typename Visit>
void walk_bvh(const GeometryView &geometry, const PreparedRay &ray, const float &t_max, Visit &&visit) {
    struct Pending {
        uint32_t link;
        float t_near;
    };
    Pending stack[(WideNode::width - 1) * max_bvh_depth + 1];
    int pending = 0;
    stack[pending++] = {ChildLink::node(0).word(), 0.0f};
    while (pending > 0) {
        const Pending now = stack[--pending];
        if (now.t_near > search_end(t_max)) continue;
        const ChildLink link(now.link);
        if (link.is_leaf()) {
            if (visit(LeafTriangles(geometry.leaf_words, link.number(), link.reference_count()))) return;
            continue;
        }
        const WideNode &node = geometry.wide_nodes[link.number()];
        const int first = pending;
        for (uint32_t i = 0; i < WideNode::width && node.child[i] != 0; ++i) {
            const auto &b = node.bounds;
            const Box box{{b[0][i], b[1][i], b[2][i]}, {b[3][i], b[4][i], b[5][i]}};
            const Interval part = clip_to_box(ray, box, t_max);
            if (part.t_near > part.t_far) continue;
            int place = pending++; // farther children lie deeper
            for (; place > first && stack[place - 1].t_near < part.t_near; --place) stack[place] = stack[place - 1];
            stack[place] = {node.child[i], part.t_near};
        }
    }
}

/// Calls visit(leaf) for every leaf that the ray may reach, in either structure.
template <typename Visit>
void walk(const GeometryView &geometry, const PreparedRay &ray, Interval part, const float &t_max, Visit &&visit) {
    if (geometry.wide_nodes) {
        walk_bvh(geometry, ray, t_max, visit);
    } else if (geometry.nodes) {
        walk_tree(geometry, ray, part, t_max, visit);
    }
}

/// Calls visit(geometry, ray, first) for what moves and the ray may meet: with its own tree, the ray in its own space,
/// and the number that its triangle_ids count from. Until a call returns true.
template <typename Visit>
void walk_insides(const GeometryView &geometry, const PreparedRay &ray, const float &t_max, Visit &&visit) {
    walk_instances(geometry.instances, ray, t_max, [&](const Instance &instance) {
        const GeometryView own = GeometryView::inside(instance);
        return visit(own, PreparedRay(ray_to_object(instance.pose, {ray.org, ray.dir}), own.bounds),
                     instance.first_triangle);
    });
}

/// The nearest triangle or quadric with 0 < t <= t_max; of several at the same t, the one with the lowest id. A flat
/// triangle never meets a ray that leaves it, so `left_triangle` (or no_triangle) is passed over; a quadric may, on its
/// other side.
inline Hit closest_hit(const GeometryView &geometry, const PreparedRay &ray, float t_max,
                       uint32_t left_triangle = no_triangle) {
    Hit best{t_max, no_triangle};
    const auto consider = [&](float t, uint32_t id) {
        if (t > 0.0f && (t < best.t || (t == best.t && id < best.triangle_id))) best = {t, id};
    };
    const auto consider_tree = [&](const GeometryView &tree, const PreparedRay &along, uint32_t first) {
        const Interval part = clip_to_box(along, tree.bounds, best.t);
        walk(tree, along, part, best.t, [&](const LeafTriangles &leaf) {
            for (uint32_t i = 0; i < leaf.count(); ++i) {
                const uint32_t id = first + leaf.triangle_id(i);
                if (id != left_triangle) consider(intersect(along, leaf.corners(i)), id);
            }
            return false;
        });
        return false;
    };
    consider_tree(geometry, ray, 0);
    walk_insides(geometry, ray, best.t, consider_tree);
    walk_quadrics(geometry.quadrics, ray, best.t, [&](const PlacedQuadric &quadric) {
        consider(quadric_distance(quadric, ray), quadric.id);
        return false;
    });
    return best;
}

/// The nearest hit behind another one at t <= t_max, by the same order: farther or, at the same t, with a greater id.
/// Of what can_block(id) allows.
template <typename CanBlock>
Hit next_hit(const GeometryView &geometry, const PreparedRay &ray, const Hit &last, float t_max, CanBlock &&can_block) {
    Hit best{t_max, no_triangle};
    const auto consider = [&](float t, uint32_t id) {
        const bool is_behind = t > last.t || (t == last.t && last.triangle_id != no_triangle && id > last.triangle_id);
        if (is_behind && t > 0.0f && (t < best.t || (t == best.t && id < best.triangle_id))) best = {t, id};
    };
    const auto consider_tree = [&](const GeometryView &tree, const PreparedRay &along, uint32_t first) {
        walk(tree, along, {0.0f, search_end(best.t)}, best.t, [&](const LeafTriangles &leaf) {
            for (uint32_t i = 0; i < leaf.count(); ++i) {
                const uint32_t id = first + leaf.triangle_id(i);
                if (can_block(id)) consider(intersect(along, leaf.corners(i)), id);
            }
            return false;
        });
        return false;
    };
    consider_tree(geometry, ray, 0);
    walk_insides(geometry, ray, best.t, consider_tree);
    walk_quadrics(geometry.quadrics, ray, best.t, [&](const PlacedQuadric &quadric) {
        if (can_block(quadric.id)) consider(quadric_distance(quadric, ray, last.t), quadric.id);
        return false;
    });
    return best;
}

/// Whether any triangle or quadric that can_block(id) allows is met at 0 < t < t_max. Meant for shadow rays, which
/// begin and end within the scene and so need not be clipped to it.
template <typename CanBlock>
bool any_hit(const GeometryView &geometry, const PreparedRay &ray, float t_max, CanBlock &&can_block) {
    bool blocked = false;
    const auto consider = [&](float t) {
        blocked = t > 0.0f && t < t_max;
        return blocked;
    };
    const auto consider_tree = [&](const GeometryView &tree, const PreparedRay &along, uint32_t first) {
        walk(tree, along, {0.0f, search_end(t_max)}, t_max, [&](const LeafTriangles &leaf) {
            for (uint32_t i = 0; i < leaf.count() && !blocked; ++i) {
                if (can_block(first + leaf.triangle_id(i))) consider(intersect(along, leaf.corners(i)));
            }
            return blocked;
        });
        return blocked;
    };
    consider_tree(geometry, ray, 0);
    if (!blocked) walk_insides(geometry, ray, t_max, consider_tree);
    if (blocked) return true;
    walk_quadrics(geometry.quadrics, ray, t_max, [&](const PlacedQuadric &quadric) {
        return can_block(quadric.id) && consider(quadric_distance(quadric, ray));
    });
    return blocked;
}

} // namespace glint
