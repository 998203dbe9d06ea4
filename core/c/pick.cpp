// What is under a finger, for C.
#include <cmath>
#include <limits>

#include <glint/ray_query.hpp>

#include "c/render_handles.hpp"
#include "c/scene_handle.hpp"
#include "c/sized.hpp"
#include "scene/camera_check.hpp"

namespace glint {

namespace {

/// The surface that has a triangle or quadric, by the scene's numbering.
SurfaceRef surface_of(const Scene &scene, uint32_t id) {
    if (id >= scene.triangle_count()) return scene.surface(scene.quadric_surfaces()[id - scene.triangle_count()]);
    uint32_t surface = 0;
    for (size_t first = 0;; ++surface) {
        const Mesh *const mesh = scene.surface_mesh(surface);
        first += mesh ? mesh->triangles.size() : 0;
        if (id < first) return scene.surface(surface);
    }
}

} // namespace

} // namespace glint

using namespace glint;

glint_error glint_renderer_pick(glint_renderer *renderer, const glint_camera *camera, double x, double y,
                                glint_pick *pick) {
    return call(renderer, [&](glint_renderer &handle) -> glint_error {
        const Scene &scene = handle.accel->scene();
        const Camera seen = camera ? camera_of(*camera) : scene.camera();
        // A place too far outside is in no direction that floats have.
        if (!is_sized(pick) || camera_problem(seen) || !(std::abs(x) <= 1e6) || !(std::abs(y) <= 1e6)) {
            return handle.refuse(
                "a pick needs a place near the window, a camera that can see, and room for the answer");
        }
        const glm::dvec3 eye(seen.eye);
        glm::dvec3 dir = glm::dvec3(seen.top_left) - eye + x * glm::dvec3(seen.right) + y * glm::dvec3(seen.down);
        dir *= 1.0 / std::sqrt(dir.x * dir.x + dir.y * dir.y + dir.z * dir.z);
        const glm::vec3 narrow(dir);
        constexpr float infinity = std::numeric_limits<float>::infinity();
        float t = infinity;
        uint32_t id = no_triangle;
        RayQuery(handle.accel, handle.renderer->isa())
            .closest_hits({1, &seen.eye.x, &seen.eye.y, &seen.eye.z, &narrow.x, &narrow.y, &narrow.z, &infinity},
                          {&t, &id});
        glint_pick found = {};
        found.size = sizeof found;
        found.distance = infinity;
        found.object = found.light = GLINT_NONE;
        if (id != no_triangle) {
            found.distance = t;
            store(glm::vec3(eye + dir * double{t}), found.position);
            const SurfaceRef surface = surface_of(scene, id);
            (surface.is_light ? found.light : found.object) = surface.index;
        }
        return give(pick, found);
    });
}
