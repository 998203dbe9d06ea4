// Whether a camera can see.
#include "scene/camera_check.hpp"

#include "scene/scene_check.hpp"

namespace glint {

std::optional<std::string> camera_problem(const Camera &camera) {
    if (!is_place(camera.eye)) return "the camera's eye is not a finite place within 1e12 of the origin";
    if (!is_place(camera.top_left) || !is_place(camera.right) || !is_place(camera.down)) {
        return "the camera's window is not finite or reaches beyond 1e12";
    }
    const glm::dvec3 right(camera.right), down(camera.down);
    const glm::dvec3 normal = {right.y * down.z - right.z * down.y, right.z * down.x - right.x * down.z,
                               right.x * down.y - right.y * down.x};
    if (normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0) return "the camera's window has no area";
    const glm::dvec3 to_window = glm::dvec3(camera.top_left) - glm::dvec3(camera.eye);
    if ((normal.x * to_window.x + normal.y * to_window.y) + normal.z * to_window.z == 0.0) {
        return "the camera's eye lies in the plane of its window";
    }
    return std::nullopt;
}

} // namespace glint
