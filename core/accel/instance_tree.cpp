// Puts a scene's moving meshes where they stand.
#include "accel/instance_tree.hpp"

#include "math/rigid.hpp"

namespace glint {

namespace {

/// The room around a box that rounding the pose and the object's way into its own space needs: those are some ten
/// roundings of eps = 2^-24 each, relative to the object's size and its distance from both origins.
float room_around(const RigidTransform &pose, const Box &own) {
    return 0x1p-18f * (max_abs(own.lo) + max_abs(own.hi) + max_abs(pose.translation));
}

Instance placed(const RigidTransform &pose, const TriangleTree &tree, uint32_t first_triangle) {
    Instance instance{};
    instance.pose = pose;
    instance.own_bounds = tree.bounds();
    instance.bounds = box_to_world(pose, instance.own_bounds);
    const float room = room_around(pose, instance.own_bounds);
    instance.bounds.lo -= room;
    instance.bounds.hi += room;
    instance.first_triangle = first_triangle;
    instance.nodes = tree.nodes();
    instance.wide_nodes = tree.wide_nodes();
    instance.leaf_words = tree.leaf_words();
    instance.triangle_count = tree.triangle_count;
    // At rest nothing is rounded. Else the way into the object's space adds some seven roundings to the three that
    // kernel/surface_point.hpp counts.
    instance.length_factor = pose == RigidTransform{} ? 1.0f : 4.0f;
    instance.least_length = pose == RigidTransform{} ? 0.0f : max_abs(pose.translation);
    return instance;
}

} // namespace

InstanceTree InstanceTree::from(const Scene &scene, const std::vector<Mover> &movers,
                                const std::vector<TriangleTree> &trees) {
    InstanceTree tree;
    std::vector<Box> boxes;
    for (const Mover &mover : movers) {
        const RigidTransform &pose = *scene.objects()[mover.object].pose;
        const TriangleTree &own = trees[mover.tree];
        tree.instances.push_back(placed(pose, own, mover.first_triangle));
        boxes.push_back(tree.instances.back().bounds);
        tree.bounds.extend(box_to_world(pose, own.bounds()));
    }
    tree.over = build_box_tree(boxes);
    return tree;
}

} // namespace glint
