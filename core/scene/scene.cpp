// Looking things up in a finished scene.
#include <glint/scene.hpp>

#include <cassert>
#include <cmath>

namespace glint {

Camera Camera::through_window(Point eye, float x0, float y0, float x1, float y1) {
    return {eye, {x0, y1, 0.0f}, {x1 - x0, 0.0f, 0.0f}, {0.0f, y0 - y1, 0.0f}};
}

Camera Camera::look_at(Point eye, Point target, Vector up, float width, float height) {
    // In double, so that the window is square to the view however far the target is.
    const auto unit = [](const glm::dvec3 &v) { return v * (1.0 / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z)); };
    const auto cross = [](const glm::dvec3 &a, const glm::dvec3 &b) {
        return glm::dvec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    };
    const glm::dvec3 forward = unit(glm::dvec3(target) - glm::dvec3(eye));
    const glm::dvec3 right = unit(cross(forward, glm::dvec3(up)));
    const glm::dvec3 upward = cross(right, forward);
    // Far from the origin floats lie too far apart for a window at distance 1. A larger one, further away in the same
    // measure, is seen as the same.
    double distance = 1.0;
    for (int i = 0; i < 3; ++i) {
        while (std::abs(double(eye[i])) > 1024.0 * distance) distance *= 2.0;
    }
    const glm::dvec3 across = right * (double(width) * distance), downward = upward * (-double(height) * distance);
    const glm::dvec3 top_left = glm::dvec3(eye) + forward * distance - across * 0.5 - downward * 0.5;
    return {eye, Point(top_left), Vector(across), Vector(downward)};
}

std::string_view sample_pattern_name(SamplePattern pattern) {
    switch (pattern) {
    case SamplePattern::centre:
        return "centre";
    case SamplePattern::stratified:
        return "stratified";
    case SamplePattern::jittered:
        return "jittered";
    }
    return "";
}

const Mesh *Scene::surface_mesh(uint32_t s) const {
    const SurfaceRef ref = surface(s);
    return ref.is_light ? lights_[ref.index].mesh.get() : objects_[ref.index].mesh.get();
}

const Quadric *Scene::surface_quadric(uint32_t s) const {
    const SurfaceRef ref = surface(s);
    const std::optional<Quadric> &quadric = ref.is_light ? lights_[ref.index].quadric : objects_[ref.index].quadric;
    return quadric ? &*quadric : nullptr;
}

SurfaceRef Scene::surface(uint32_t s) const {
    assert(s < surface_count());
    const auto object_count = static_cast<uint32_t>(objects_.size());
    return s < object_count ? SurfaceRef{false, s} : SurfaceRef{true, s - object_count};
}

} // namespace glint
