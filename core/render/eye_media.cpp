// What an eye stands in: closed meshes are asked for the solid angle that they cover, seen from there.
#include "render/eye_media.hpp"

#include <cmath>

#include "math/box.hpp"

namespace glint {

namespace {

double dot(const glm::dvec3 &a, const glm::dvec3 &b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Signed solid angle of a triangle (van Oosterom & Strackee 1983, "The solid angle of a plane triangle").
double solid_angle(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c) {
    const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
    const glm::dvec3 bc(b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x);
    return 2.0 * std::atan2(dot(a, bc), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

/// A closed mesh covers the whole sphere of directions from inside, and nothing from outside, however it is wound.
bool holds(const Mesh &mesh, const Point &eye) {
    Box bounds;
    for (const Point &p : mesh.positions) bounds.extend(p);
    for (int axis = 0; axis < 3; ++axis) {
        if (!(eye[axis] > bounds.lo[axis] && eye[axis] < bounds.hi[axis])) return false;
    }
    double covered = 0.0;
    const auto seen = [&](uint32_t i) { return glm::dvec3(mesh.positions[i]) - glm::dvec3(eye); };
    for (const Triangle &t : mesh.triangles) covered += solid_angle(seen(t.a), seen(t.b), seen(t.c));
    constexpr double half_sphere = 6.283185307179586;
    return std::abs(covered) > half_sphere;
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
        if (!(quadric ? holds(*quadric, eye) : holds(*scene.surface_mesh(s), eye))) continue;
        for (int i = Media::most - 1; i > 0; --i) media.inside[i] = media.inside[i - 1];
        media.inside[0] = s;
    }
    return media;
}

} // namespace glint
