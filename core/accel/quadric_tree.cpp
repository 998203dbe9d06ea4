// Puts a scene's quadrics into a hierarchy of boxes.
#include "accel/quadric_tree.hpp"

#include "accel/bvh/binary_bvh.hpp"
#include "accel/triangle_data.hpp"
#include "scene/quadric_shape.hpp"

namespace glint {

namespace {

PlacedQuadric placed(const Quadric &q, const Box &bounds, uint32_t id) {
    return {q.a, q.b, q.c, q.d, q.e, q.f, q.g, q.h, q.j, q.k, bounds, id};
}

/// Puts them behind the others, and a hierarchy over them.
void add_bounded(const std::vector<PlacedQuadric> &bounded, QuadricTree &tree) {
    // To the builder, which looks at bounds and their centres alone, a box is as good as a triangle across it.
    std::vector<TriangleCorners> boxes;
    for (const PlacedQuadric &q : bounded) boxes.push_back({q.bounds.lo, q.bounds.hi, q.bounds.lo});
    const BinaryBvh bvh = build_binary_bvh(boxes, 1);
    // Not all of the builder's places for nodes are used: number anew, so that none is empty.
    std::vector<uint32_t> built{0};
    for (uint32_t i = 0; i < built.size(); ++i) {
        const BinaryNode &node = bvh.nodes[built[i]];
        const Box box{{node.lo[0], node.lo[1], node.lo[2]}, {node.hi[0], node.hi[1], node.hi[2]}};
        const auto next = static_cast<uint32_t>(built.size());
        tree.nodes.push_back({box, node.is_leaf() ? tree.unbounded_count + node.first : next, node.count});
        if (!node.is_leaf()) built.insert(built.end(), {node.first, node.first + 1});
    }
    for (const uint32_t i : bvh.triangle_ids) tree.quadrics.push_back(bounded[i]);
}

} // namespace

QuadricTree QuadricTree::from(const Scene &scene) {
    QuadricTree tree;
    std::vector<PlacedQuadric> bounded;
    uint32_t id = scene.triangle_count();
    for (const uint32_t surface : scene.quadric_surfaces()) {
        const Quadric &quadric = *scene.surface_quadric(surface);
        const QuadricShape shape = quadric_shape(quadric);
        (shape.is_bounded ? bounded : tree.quadrics).push_back(placed(quadric, shape.bounds, id++));
        if (shape.is_bounded) tree.bounds.extend(shape.bounds);
    }
    tree.unbounded_count = static_cast<uint32_t>(tree.quadrics.size());
    if (!bounded.empty()) add_bounded(bounded, tree);
    tree.places.resize(tree.quadrics.size());
    for (uint32_t i = 0; i < tree.quadrics.size(); ++i) tree.places[tree.quadrics[i].id - scene.triangle_count()] = i;
    return tree;
}

} // namespace glint
