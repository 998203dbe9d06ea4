// The camera's control, for C.
#include <glint/view.h>

#include <cmath>
#include <optional>

#include <glint/camera_control.hpp>

#include "c/scene_handle.hpp"

struct glint_camera_control : glint::HandleOf<glint::HandleKind::camera_control> {
    [[nodiscard]] bool is_made() const { return control.has_value(); }

    std::optional<glint::CameraControl> control;
};

using namespace glint;

namespace {

/// Unset where what is hit is not known, or nothing is.
std::optional<double> known(double distance) {
    return distance > 0.0 && std::isfinite(distance) ? std::optional(distance) : std::nullopt;
}

/// Moves a camera by what `move` does with its control.
template <typename Move> glint_error moved(glint_camera_control *control, Move &&move) {
    return call(control, [&](glint_camera_control &handle) -> glint_error {
        move(*handle.control);
        return GLINT_OK;
    });
}

} // namespace

glint_error glint_camera_control_create(const glint_scene *scene, uint32_t width_px, uint32_t height_px,
                                        glint_camera_control **control) {
    return create(control, [&](glint_camera_control &handle) -> glint_error {
        if (!is_made(scene)) return handle.refuse("there is no scene");
        const PictureSettings &picture = scene->scene->picture();
        if ((width_px == 0) != (height_px == 0)) return handle.refuse("the window has no pixels");
        handle.control.emplace(scene->scene, width_px > 0 ? width_px : picture.width_px,
                               height_px > 0 ? height_px : picture.height_px);
        return GLINT_OK;
    });
}

void glint_camera_control_release(glint_camera_control *control) {
    release(control);
}

glint_error glint_camera_control_get_camera(const glint_camera_control *control, glint_camera *camera) {
    if (!is_made(control) || !camera) return GLINT_ERROR_INVALID_ARGUMENT;
    *camera = c_camera_of(control->control->camera());
    return GLINT_OK;
}

glint_error glint_camera_control_orbit(glint_camera_control *control, double drag_x, double drag_y) {
    return moved(control, [&](CameraControl &camera) { camera.orbit({drag_x, drag_y}); });
}

glint_error glint_camera_control_pan(glint_camera_control *control, double from_x, double from_y, double to_x,
                                     double to_y, double distance) {
    return moved(control, [&](CameraControl &camera) { camera.pan({from_x, from_y}, {to_x, to_y}, known(distance)); });
}

glint_error glint_camera_control_zoom(glint_camera_control *control, double x, double y, double factor,
                                      double distance) {
    return moved(control, [&](CameraControl &camera) { camera.zoom({x, y}, factor, known(distance)); });
}

glint_error glint_camera_control_fly(glint_camera_control *control, double right, double up, double ahead,
                                     double seconds) {
    return moved(control, [&](CameraControl &camera) { camera.fly({right, up, ahead}, seconds); });
}

glint_error glint_camera_control_reset(glint_camera_control *control) {
    return moved(control, [&](CameraControl &camera) { camera.reset(); });
}

glint_error glint_camera_control_frame(glint_camera_control *control) {
    return moved(control, [&](CameraControl &camera) { camera.frame(); });
}

glint_error glint_camera_control_resize(glint_camera_control *control, uint32_t width_px, uint32_t height_px) {
    return call(control, [&](glint_camera_control &handle) -> glint_error {
        if (width_px == 0 || height_px == 0) return handle.refuse("the window has no pixels");
        handle.control->resize(width_px, height_px);
        return GLINT_OK;
    });
}
