// What an eye stands in: rays from inside a closed mesh meet it an odd number of times.
#include "render/eye_media.hpp"

#include "kernel/intersect.hpp"
#include "math/box.hpp"
#include "math/rigid.hpp"

namespace glint {

namespace {

/// Whether a ray from the eye meets the mesh an odd number of times, and so leaves it for good once more than it enters
/// it.
bool leaves(const Mesh &mesh, const Ray &ray, const Box &bounds) {
    const PreparedRay prepared(ray, bounds);
    bool odd = false;
    for (const Triangle &t : mesh.triangles) {
        if (intersect(prepared, {mesh.positions[t.a], mesh.positions[t.b], mesh.positions[t.c]}) > 0.0f) odd = !odd;
    }
    return odd;
}

/// However the mesh is wound. Edges, which a ray meets twice, are hard to hit from three directions at once.
bool holds(const Mesh &mesh, const Point &eye) {
    Box bounds;
    for (const Point &p : mesh.positions) bounds.extend(p);
    for (int axis = 0; axis < 3; ++axis) {
        if (!(eye[axis] > bounds.lo[axis] && eye[axis] < bounds.hi[axis])) return false;
    }
    int votes = 0;
    for (const glm::vec3 &dir : {glm::vec3(0.5773f, 0.6131f, 0.5394f), glm::vec3(-0.7253f, 0.3141f, -0.6127f),
                                 glm::vec3(0.2718f, -0.9173f, 0.2911f)}) {
        votes += leaves(mesh, {eye, dir}, bounds) ? 1 : -1;
    }
    return votes > 0;
}

bool holds(const Quadric &q, const Point &eye) {
    const double x = eye.x, y = eye.y, z = eye.z;
    const double value = q.a * x * x + q.b * y * y + q.c * z * z +
                         2.0 * (q.d * x * y + q.e * y * z + q.f * x * z + q.g * x + q.h * y + q.j * z) + q.k;
    const bool is_turned = double(q.a) + q.b + q.c < 0.0;
    return is_turned ? value > 0.0 : value < 0.0;
}

} // namespace

Media media_around(const Scene &scene, const Point &eye) {
    Media media;
    for (uint32_t &surface : media.inside) surface = no_surface;
    for (uint32_t s = 0; s < scene.surface_count(); ++s) {
        const SurfaceRef ref = scene.surface(s);
        if (ref.is_light || !(scene.objects()[ref.index].material.transmission > 0.0f)) continue;
        const Quadric *const quadric = scene.surface_quadric(s);
        const std::optional<RigidTransform> &pose = scene.objects()[ref.index].pose;
        const Point own_eye = pose ? point_to_object(*pose, eye) : eye;
        if (!(quadric ? holds(*quadric, own_eye) : holds(*scene.surface_mesh(s), own_eye))) continue;
        for (int i = Media::most - 1; i > 0; --i) media.inside[i] = media.inside[i - 1];
        media.inside[0] = s;
    }
    return media;
}

} // namespace glint
