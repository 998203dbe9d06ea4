// Looking things up in a finished scene.
#include <glint/scene.hpp>

#include <cassert>

namespace glint {

Camera Camera::through_window(Point eye, float x0, float y0, float x1, float y1) {
    return {eye, {x0, y1, 0.0f}, {x1 - x0, 0.0f, 0.0f}, {0.0f, y0 - y1, 0.0f}};
}

const Mesh &Scene::surface_mesh(uint32_t s) const {
    const SurfaceRef ref = surface(s);
    return ref.is_light ? *lights_[ref.index].mesh : *objects_[ref.index].mesh;
}

SurfaceRef Scene::surface(uint32_t s) const {
    assert(s < surface_count());
    const auto object_count = static_cast<uint32_t>(objects_.size());
    return s < object_count ? SurfaceRef{false, s} : SurfaceRef{true, s - object_count};
}

} // namespace glint
