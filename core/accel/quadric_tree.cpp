// Puts a scene's quadrics into a hierarchy of boxes.
#include "accel/quadric_tree.hpp"

#include "math/rigid.hpp"
#include "scene/quadric_shape.hpp"

namespace glint {

namespace {

/// A symmetric matrix, a vector and a number: the quadric is p.Mp + 2 v.p + k.
struct Form {
    glm::dvec3 rows[3];
    glm::dvec3 v;
    double k;
};

/// What the form becomes for points of the world: with p = R^T (w - t) it is w.Nw + 2 (R v - N t).w + ..., N = R M R^T.
Form moved(const Form &form, const RigidTransform &pose) {
    const glm::dvec3 axes[3] = {glm::dvec3(pose.x), glm::dvec3(pose.y), glm::dvec3(pose.z)};
    const glm::dvec3 t(pose.translation);
    const auto dot = [](const glm::dvec3 &a, const glm::dvec3 &b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; };
    const auto turned = [&](const glm::dvec3 &a) { return (axes[0] * a.x + axes[1] * a.y) + axes[2] * a.z; };
    const glm::dvec3 half[3] = {turned(form.rows[0]), turned(form.rows[1]), turned(form.rows[2])}; // the rows of M R^T
    Form result;
    for (int i = 0; i < 3; ++i) {
        result.rows[i] = (half[0] * axes[0][i] + half[1] * axes[1][i]) + half[2] * axes[2][i];
    }
    const glm::dvec3 of_t(dot(result.rows[0], t), dot(result.rows[1], t), dot(result.rows[2], t));
    const glm::dvec3 v = turned(form.v);
    result.v = v - of_t;
    result.k = (form.k - 2.0 * dot(v, t)) + dot(of_t, t);
    return result;
}

/// With room for what rounding the pose moves; the identity's stay as they are.
Box box_of(const QuadricShape &shape, const RigidTransform &pose) {
    if (!shape.is_bounded || pose == RigidTransform{}) return shape.bounds;
    Box box = box_to_world(pose, shape.bounds);
    const float room = 0x1p-18f * (max_abs(shape.bounds.lo) + max_abs(shape.bounds.hi) + max_abs(pose.translation));
    box.lo -= room;
    box.hi += room;
    return box;
}

PlacedQuadric placed(const Quadric &q, const Box &bounds, const RigidTransform &pose, uint32_t id) {
    const Form own{{{q.a, q.d, q.f}, {q.d, q.b, q.e}, {q.f, q.e, q.c}}, {q.g, q.h, q.j}, q.k};
    const Form m = moved(own, pose);
    return {m.rows[0].x, m.rows[1].y, m.rows[2].z, m.rows[0].y, m.rows[1].z, m.rows[0].z,
            m.v.x,       m.v.y,       m.v.z,       m.k,         bounds,      id};
}

} // namespace

QuadricTree QuadricTree::from(const Scene &scene) {
    QuadricTree tree;
    std::vector<PlacedQuadric> bounded;
    std::vector<Box> boxes;
    uint32_t id = scene.triangle_count();
    for (const uint32_t surface : scene.quadric_surfaces()) {
        const Quadric &quadric = *scene.surface_quadric(surface);
        const QuadricShape shape = quadric_shape(quadric);
        const SurfaceRef ref = scene.surface(surface);
        const RigidTransform pose =
            ref.is_light ? RigidTransform{} : scene.objects()[ref.index].pose.value_or(RigidTransform{});
        const Box box = box_of(shape, pose);
        (shape.is_bounded ? bounded : tree.quadrics).push_back(placed(quadric, box, pose, id++));
        if (!shape.is_bounded) continue;
        tree.bounds.extend(box);
        boxes.push_back(box);
    }
    tree.unbounded_count = static_cast<uint32_t>(tree.quadrics.size());
    BoxTree over = build_box_tree(boxes);
    for (const uint32_t i : over.order) tree.quadrics.push_back(bounded[i]);
    tree.nodes = std::move(over.nodes);
    tree.places.resize(tree.quadrics.size());
    for (uint32_t i = 0; i < tree.quadrics.size(); ++i) tree.places[tree.quadrics[i].id - scene.triangle_count()] = i;
    return tree;
}

} // namespace glint
