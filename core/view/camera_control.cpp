// A camera that a person moves.
//
// All of it is linear algebra on one matrix. Its columns are the vector from the eye to the window's top left corner
// and the window's upper and left edge, so that the ray through the place (u, v) has the direction
//
//     window * (1, u, v)
//
// and a point p is seen at (b / a, c / a) where (a, b, c) = inverse(window) * (p - eye). `a` is how deep the point is:
// as many times as deep as the window. That holds for windows off the axis, and for skewed ones too.
#include <glint/camera_control.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene/camera_check.hpp"
#include "view/scene_bounds.hpp"

namespace glint {

namespace {

constexpr double pi = 3.14159265358979323846;
/// As near to a pole as orbits go.
constexpr double least_polar_angle = pi / 180.0;
/// How near the pivot comes, and how far it gets, in scene radii.
constexpr double nearest = 1e-5, furthest = 1e3;
/// The window is at least so deep, as a share of the eye's largest coordinate: floats are that fine there.
constexpr double least_window_depth = 1.0 / 64.0;

bool is_finite(const glm::dvec3 &v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
bool is_finite(const glm::dvec2 &v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

double largest(const glm::dvec3 &v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// In floats; what is beyond max_coordinate stays beyond it.
glm::vec3 narrowed(const glm::dvec3 &v) {
    return glm::vec3(glm::clamp(v, -2.0 * double{max_coordinate}, 2.0 * double{max_coordinate}));
}

/// `v`, turned around a unit axis (Rodrigues 1840).
glm::dvec3 turned(const glm::dvec3 &v, const glm::dvec3 &axis, double angle) {
    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
           axis * (glm::dot(axis, v) * (1.0 - std::cos(angle)));
}

glm::dmat3 turned(const glm::dmat3 &m, const glm::dvec3 &axis, double angle) {
    return {turned(m[0], axis, angle), turned(m[1], axis, angle), turned(m[2], axis, angle)};
}

/// The coordinate axis nearest to a direction.
glm::dvec3 nearest_axis(const glm::dvec3 &v) {
    glm::dvec3 axis(0.0);
    const glm::dvec3 size = glm::abs(v);
    const int i = size.y >= size.x && size.y >= size.z ? 1 : size.x >= size.z ? 0 : 2;
    axis[i] = v[i] < 0.0 ? -1.0 : 1.0;
    return axis;
}

} // namespace

CameraControl::CameraControl(std::shared_ptr<const Scene> scene)
    : CameraControl(scene, scene->picture().width_px, scene->picture().height_px) {}

CameraControl::CameraControl(std::shared_ptr<const Scene> scene, uint32_t width_px, uint32_t height_px)
    : scene_(std::move(scene)), width_px_(std::max(width_px, 1u)), height_px_(std::max(height_px, 1u)) {
    const Camera &camera = scene_->camera();
    first_.eye = camera.eye;
    first_.window = {glm::dvec3(camera.top_left) - glm::dvec3(camera.eye), camera.right, camera.down};
    up_ = nearest_axis(-first_.window[2]);

    const glm::dvec3 ahead = first_.window * glm::dvec3(1.0, 0.5, 0.5);
    first_.pivot = first_.eye + ahead;
    radius_ = glm::length(ahead);
    const Box bounds = bounds_of_objects(*scene_);
    has_bounds_ = !bounds.empty();
    if (has_bounds_) {
        lo_ = bounds.lo;
        hi_ = bounds.hi;
        radius_ = std::max(0.5 * glm::length(hi_ - lo_), 1e-30);
        const glm::dvec3 middle = 0.5 * (lo_ + hi_);
        state_ = first_;
        const auto place = place_of(middle);
        const double distance = glm::length(middle - first_.eye);
        const bool is_seen = place && largest({place->x - 0.5, place->y - 0.5, 0.0}) <= 0.5;
        first_.pivot = is_seen && distance > nearest * radius_
                           ? middle
                           : first_.eye + glm::normalize(ahead) * std::max(distance, 0.1 * radius_);
    }
    state_ = first_;
}

glm::dmat3 CameraControl::widened() const {
    const glm::dmat3 &window = state_.window;
    return {window[0] + window[1] * (0.5 - 0.5 * widening_), window[1] * widening_, window[2]};
}

Camera CameraControl::camera() const {
    if (!state_.is_moved && widening_ == 1.0) return scene_->camera();
    // The same picture through a window that is further away, and as much larger.
    const glm::dmat3 window = widened();
    const double depth = largest(window * glm::dvec3(1.0, 0.5, 0.5));
    const double enlarging = std::max(1.0, least_window_depth * largest(state_.eye) / depth);
    return {narrowed(state_.eye), narrowed(state_.eye + window[0] * enlarging), narrowed(window[1] * enlarging),
            narrowed(window[2] * enlarging)};
}

void CameraControl::move_to(const State &next) {
    const State before = state_;
    state_ = next;
    state_.is_moved = true;
    // Written so that NaN fails.
    const bool is_within =
        largest(state_.eye) <= double{max_coordinate} && largest(state_.pivot) <= double{max_coordinate};
    if (!is_within || camera_problem(camera())) state_ = before;
}

void CameraControl::orbit(glm::dvec2 drag) {
    if (!is_finite(drag)) return;
    State next = state_;
    const glm::dvec3 arm = next.eye - next.pivot;
    const glm::dvec3 sideways = glm::cross(up_, arm);
    const double across = glm::length(sideways);
    if (across > 0.0) {
        // Angles from the upper pole. One that is too near to a pole, as a first camera's may be, only leaves it.
        const double from = std::atan2(across, glm::dot(up_, arm));
        const double to =
            std::clamp(from - pi * drag.y, std::min(from, least_polar_angle), std::max(from, pi - least_polar_angle));
        const glm::dvec3 axis = sideways / across;
        next.window = turned(next.window, axis, to - from);
        next.eye = next.pivot + turned(arm, axis, to - from);
    }
    const double turn = -2.0 * pi * std::fmod(drag.x, 1.0);
    next.window = turned(next.window, up_, turn);
    next.eye = next.pivot + turned(next.eye - next.pivot, up_, turn);
    move_to(next);
}

void CameraControl::pan(glm::dvec2 from, glm::dvec2 to, std::optional<double> distance) {
    if (!is_finite(from) || !is_finite(to)) return;
    const glm::dmat3 window = widened();
    const glm::dvec3 step = window * glm::dvec3(0.0, from - to) * depth_at(from, distance);
    State next = state_;
    next.eye += step;
    next.pivot += step;
    move_to(next);
}

void CameraControl::zoom(glm::dvec2 cursor, double factor, std::optional<double> distance) {
    if (!is_finite(cursor) || !(factor > 0.0) || !std::isfinite(factor)) return;
    // The eye and its pivot come nearer to the place in the same measure, so that the pivot is seen where it was.
    State next = state_;
    const double pivot_distance = glm::length(next.pivot - next.eye);
    const double least = std::min(1.0, nearest * radius_ / pivot_distance);
    const double greatest = std::max(1.0, furthest * radius_ / pivot_distance);
    const double share = std::clamp(factor, least, greatest);
    const glm::dvec3 place = next.eye + widened() * glm::dvec3(1.0, cursor) * depth_at(cursor, distance);
    next.eye = place + (next.eye - place) * share;
    next.pivot = place + (next.pivot - place) * share;
    move_to(next);
}

void CameraControl::fly(glm::dvec3 velocity, double seconds) {
    if (!is_finite(velocity) || !std::isfinite(seconds)) return;
    const glm::dvec3 step = glm::normalize(state_.window[1]) * velocity.x -
                            glm::normalize(state_.window[2]) * velocity.y + direction_to({0.5, 0.5}) * velocity.z;
    State next = state_;
    next.eye += step * (radius_ * seconds);
    next.pivot += step * (radius_ * seconds);
    move_to(next);
}

void CameraControl::reset() {
    state_ = first_;
    if (camera_problem(camera())) widening_ = 1.0;
}

void CameraControl::frame() {
    if (!has_bounds_) return;
    // A corner (a, b, c) of the bounds is seen from an eye (x, y, z), both in the window's coordinates, between the
    // margins m and 1 - m where m (a - x) <= b - y <= (1 - m) (a - x): two planes that the eye must lie behind. The
    // tightest of all corners on both sides give the nearest x; the same for c and z, and the further of both counts.
    const glm::dmat3 window = widened();
    const glm::dmat3 to_window = glm::inverse(window);
    const glm::dvec3 middle = 0.5 * (lo_ + hi_);
    constexpr double none = std::numeric_limits<double>::infinity();
    double least[2] = {none, none}, greatest[2] = {-none, -none};
    glm::dvec3 eye;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{corner & 1 ? hi_.x : lo_.x, corner & 2 ? hi_.y : lo_.y, corner & 4 ? hi_.z : lo_.z};
        const glm::dvec3 q = to_window * (p - middle);
        for (int side = 0; side < 2; ++side) {
            const double low = q[side + 1] - frame_margin * q.x, high = q[side + 1] - (1.0 - frame_margin) * q.x;
            least[side] = std::min(least[side], low);
            greatest[side] = std::max(greatest[side], high);
        }
    }
    constexpr double shown = 1.0 - 2.0 * frame_margin;
    eye.x = std::min((least[0] - greatest[0]) / shown, (least[1] - greatest[1]) / shown);
    for (int side = 0; side < 2; ++side) {
        eye[side + 1] = 0.5 * ((least[side] + frame_margin * eye.x) + (greatest[side] + (1.0 - frame_margin) * eye.x));
    }
    State next = state_;
    next.eye = middle + window * eye;
    next.pivot = middle;
    move_to(next);
}

void CameraControl::resize(uint32_t width_px, uint32_t height_px) {
    // Products of whole numbers: a window of the first shape is not widened at all.
    const uint64_t shape = uint64_t{std::max(width_px, 1u)} * height_px_;
    const uint64_t first_shape = uint64_t{std::max(height_px, 1u)} * width_px_;
    const double before = widening_;
    widening_ = static_cast<double>(shape) / static_cast<double>(first_shape);
    if (camera_problem(camera())) widening_ = before;
}

std::optional<glm::dvec2> CameraControl::place_of(const glm::dvec3 &point) const {
    const glm::dvec3 seen = glm::inverse(widened()) * (point - state_.eye);
    if (!(seen.x > 0.0)) return std::nullopt;
    return glm::dvec2(seen.y / seen.x, seen.z / seen.x);
}

glm::dvec3 CameraControl::direction_to(glm::dvec2 place) const {
    return glm::normalize(widened() * glm::dvec3(1.0, place));
}

double CameraControl::depth_at(glm::dvec2 place, std::optional<double> distance) const {
    const glm::dmat3 window = widened();
    if (distance && *distance > 0.0 && std::isfinite(*distance)) {
        return *distance / glm::length(window * glm::dvec3(1.0, place));
    }
    return (glm::inverse(window) * (state_.pivot - state_.eye)).x;
}

} // namespace glint
