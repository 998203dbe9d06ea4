// Cameras, poses and quadrics for C, and back.
#include <glint/scene_builder.h>

#include <cmath>

#include "c/scene_handle.hpp"

namespace glint {

namespace {

/// Whether these are numbers that a place in a scene may have.
bool are_places(const float *v, int count = 3) {
    for (int i = 0; i < count; ++i) {
        if (!(std::abs(v[i]) <= max_coordinate)) return false;
    }
    return true;
}

glm::vec3 vec3_at(const float *v) {
    return {v[0], v[1], v[2]};
}

} // namespace

Camera camera_of(const glint_camera &camera) {
    return {vec3_of(camera.eye), vec3_of(camera.top_left), vec3_of(camera.right), vec3_of(camera.down)};
}

glint_camera c_camera_of(const Camera &camera) {
    glint_camera made;
    store(camera.eye, made.eye);
    store(camera.top_left, made.top_left);
    store(camera.right, made.right);
    store(camera.down, made.down);
    return made;
}

RigidTransform pose_of(const glint_pose &pose) {
    return {vec3_of(pose.x), vec3_of(pose.y), vec3_of(pose.z), vec3_of(pose.translation)};
}

glint_pose c_pose_of(const RigidTransform &pose) {
    glint_pose made;
    store(pose.x, made.x);
    store(pose.y, made.y);
    store(pose.z, made.z);
    store(pose.translation, made.translation);
    return made;
}

} // namespace glint

using namespace glint;

glint_error glint_camera_look_at(const float *eye, const float *target, const float *up, float width, float height,
                                 glint_camera *camera) {
    const float sizes[2] = {width, height};
    if (!eye || !target || !up || !camera || !are_places(eye) || !are_places(target) || !are_places(up) ||
        !are_places(sizes, 2)) {
        return GLINT_ERROR_INVALID_ARGUMENT;
    }
    const Camera made = Camera::look_at(vec3_at(eye), vec3_at(target), vec3_at(up), width, height);
    const glint_camera result = c_camera_of(made);
    if (!are_places(result.top_left) || !are_places(result.right) || !are_places(result.down)) {
        return GLINT_ERROR_INVALID_ARGUMENT; // no direction to look in
    }
    *camera = result;
    return GLINT_OK;
}

glint_error glint_pose_turned(const float *axis, double angle_rad, const float *pivot, const float *moved_by,
                              glint_pose *pose) {
    static constexpr float zero[3] = {};
    if (!pivot) pivot = zero;
    if (!moved_by) moved_by = zero;
    if (!axis || !pose || !are_places(axis) || !are_places(pivot) || !are_places(moved_by) ||
        !std::isfinite(angle_rad)) {
        return GLINT_ERROR_INVALID_ARGUMENT;
    }
    const glint_pose made =
        c_pose_of(RigidTransform::turned(vec3_at(axis), angle_rad, vec3_at(pivot), vec3_at(moved_by)));
    if (!are_places(made.x) || !are_places(made.y) || !are_places(made.z)) return GLINT_ERROR_INVALID_ARGUMENT;
    *pose = made;
    return GLINT_OK;
}

glint_error glint_quadric_sphere(const float *centre, float radius, glint_quadric *quadric) {
    static constexpr float zero[3] = {};
    if (!centre) centre = zero;
    if (!quadric || !(radius > 0.0f) || !are_places(&radius, 1) || !are_places(centre)) {
        return GLINT_ERROR_INVALID_ARGUMENT;
    }
    const double x = centre[0], y = centre[1], z = centre[2], r = radius;
    *quadric = {1.0f, 1.0f,       1.0f,       0.0f,       0.0f,
                0.0f, -centre[0], -centre[1], -centre[2], static_cast<float>(x * x + y * y + z * z - r * r)};
    return GLINT_OK;
}
