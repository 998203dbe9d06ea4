// A ray through a hierarchy over boxes.
#pragma once

#include "accel/box_tree.hpp"
#include "kernel/clip.hpp"

namespace glint {

/// Calls visit(i) for every place i in the order of the boxes, of which there are some, which the ray may meet
/// before search_end(t_max), until a call returns true. `visit` may lower t_max.
template <typename Visit>
void walk_boxes(const BoxNode *nodes, const PreparedRay &ray, const float &t_max, Visit &&visit) {
    uint32_t stack[max_box_tree_depth + 1];
    int pending = 0;
    stack[pending++] = 0;
    while (pending > 0) {
        const BoxNode &node = nodes[stack[--pending]];
        const Interval part = clip_to_box(ray, node.bounds, t_max);
        if (part.t_near > part.t_far) continue;
        if (node.count == 0) {
            const Box &first = nodes[node.first].bounds, &second = nodes[node.first + 1].bounds;
            const uint32_t near = is_second_nearer(first, second, ray.dir.x, ray.dir.y, ray.dir.z) ? 1 : 0;
            stack[pending++] = node.first + 1 - near;
            stack[pending++] = node.first + near;
            continue;
        }
        if (visit(node.first)) return;
    }
}

} // namespace glint
