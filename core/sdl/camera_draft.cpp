// The camera that an SDL file's directives make together: through a window on the plane z = 0, or looking at a target.
#include "sdl/camera_draft.hpp"

#include <cmath>
#include <string>

#include <glm/vec3.hpp>

#include "scene/camera_check.hpp"

namespace glint {

namespace {

bool is_read(const glm::vec3 &v) {
    return !std::isnan(v.x) && !std::isnan(v.y) && !std::isnan(v.z); // what could not be read was told of already
}

std::optional<Camera> checked(const Camera &camera, const Place &place, Problems &problems) {
    auto problem = camera_problem(camera);
    if (!problem) return camera;
    problems.error(place, std::move(*problem));
    return std::nullopt;
}

/// `ortho`, the oldest form.
std::optional<Camera> through_window(const SceneDraft &draft, Problems &problems) {
    bool ok = true;
    const auto belongs_to_target = [&](const Place &place, const char *keyword) {
        problems.error(place, std::string("'") + keyword + "' belongs to a camera with a target",
                       "add a line 'target x y z', or take 'ortho x0 y0 x1 y1'");
        ok = false;
    };
    if (draft.up) belongs_to_target(draft.up->place, "up");
    if (draft.window_size) belongs_to_target(draft.window_size->place, "window_size");
    if (draft.fov) belongs_to_target(draft.fov->place, "fov");

    const Given<Point> &eye = *draft.eye;
    if (eye.value.z == 0.0f) {
        problems.error(eye.place, "the eye lies in the image plane z = 0",
                       "rays start at the eye and go through that plane");
        return std::nullopt;
    }
    const Given<Window> window = draft.ortho.value_or(Given<Window>{});
    const Window &w = window.value;
    const Camera camera = Camera::through_window(eye.value, w.x0, w.y0, w.x1, w.y1);
    const bool has_area = camera.right.x != 0.0f && camera.down.y != 0.0f;
    if (!ok || !is_read(eye.value) || !is_read(camera.top_left) || !is_read(camera.down) || !has_area) {
        return std::nullopt;
    }
    return checked(camera, window.place, problems);
}

/// At distance 1.
WindowSize window_of(const SceneDraft &draft) {
    if (!draft.fov) return draft.window_size ? draft.window_size->value : WindowSize{};
    constexpr double pi = 3.141592653589793;
    const double height = 2.0 * std::tan(0.5 * double(draft.fov->value) * pi / 180.0);
    const double aspect = double(draft.picture.width_px) / double(draft.picture.height_px);
    return {static_cast<float>(height * aspect), static_cast<float>(height)};
}

std::optional<Camera> looking_at(const SceneDraft &draft, Problems &problems) {
    const Point eye = draft.eye->value, target = draft.target->value;
    const Vector up = draft.up ? draft.up->value : Vector(0.0f, 1.0f, 0.0f);
    if (draft.ortho) {
        problems.error(draft.ortho->place, "'ortho' is a window on the plane z = 0, and the camera has a target",
                       "with 'target', 'window_size w h' or 'fov degrees' says how much is seen");
        return std::nullopt;
    }
    if (draft.fov && draft.window_size) {
        problems.error(draft.fov->place, "'fov' and 'window_size' both say how much is seen", "take one of them");
        return std::nullopt;
    }
    if (!is_read(eye) || !is_read(target) || !is_read(up)) return std::nullopt;
    const glm::dvec3 v = glm::dvec3(target) - glm::dvec3(eye), u(up);
    if (v == glm::dvec3(0.0)) {
        problems.error(draft.target->place, "the target is where the eye is");
        return std::nullopt;
    }
    const glm::dvec3 across(v.y * u.z - v.z * u.y, v.z * u.x - v.x * u.z, v.x * u.y - v.y * u.x);
    const auto squared = [](const glm::dvec3 &a) { return a.x * a.x + a.y * a.y + a.z * a.z; };
    if (squared(across) <= 1e-12 * squared(v) * squared(u)) {
        const char *const message = !draft.up              ? "the view goes straight up or down, where up (0 1 0) says "
                                                             "nothing"
                                    : u == glm::dvec3(0.0) ? "'up' is zero"
                                                           : "'up' points along the view";
        problems.error(draft.up ? draft.up->place : draft.target->place, message,
                       "give a line 'up x y z' across the view");
        return std::nullopt;
    }
    const WindowSize window = window_of(draft);
    if (std::isnan(window.width) || std::isnan(window.height)) return std::nullopt;
    return checked(Camera::look_at(eye, target, up, window.width, window.height), draft.target->place, problems);
}

} // namespace

EyeMotion::View view_of(const SceneDraft &draft) {
    const WindowSize window = window_of(draft);
    const Vector up = draft.up ? draft.up->value : Vector(0.0f, 1.0f, 0.0f);
    return {draft.target->value, up, window.width, window.height};
}

std::optional<Camera> camera_of(const SceneDraft &draft, Problems &problems) {
    if (!draft.eye) return std::nullopt;
    return draft.target ? looking_at(draft, problems) : through_window(draft, problems);
}

} // namespace glint
