// How objects and the eye move with time.
#include <glint/animation.hpp>

#include <algorithm>
#include <cmath>
#include <new>

#include <glint/motion.hpp>

#include "scene/animation_check.hpp"
#include "scene/attitude.hpp"
#include "scene/camera_check.hpp"
#include "scene/scene_edit.hpp"

namespace glint {

namespace {

/// Where a time lies among keys: between two of them, or at one.
template <typename Key> struct Moment {
    const Key &from, &to;
    double share; ///< of the way from one to the other
};
template <typename Key> Moment<Key> moment_of(const std::vector<Key> &keys, double time_s) {
    const auto next = std::upper_bound(keys.begin(), keys.end(), time_s,
                                       [](double time, const Key &key) { return time < key.time_s; });
    if (next == keys.begin()) return {keys.front(), keys.front(), 0.0};
    if (next == keys.end()) return {keys.back(), keys.back(), 0.0};
    const Key &from = *(next - 1);
    return {from, *next, (time_s - from.time_s) / (next->time_s - from.time_s)};
}

Point place_at(const std::vector<PlaceKey> &keys, double time_s) {
    const Moment<PlaceKey> at = moment_of(keys, time_s);
    const glm::dvec3 from(at.from.place), to(at.to.place);
    return Point(from * (1.0 - at.share) + to * at.share);
}

Attitude attitude_at(const std::vector<TurnKey> &keys, double time_s) {
    const Moment<TurnKey> at = moment_of(keys, time_s);
    if (at.from.axis == at.to.axis) {
        return attitude_of(at.from.axis, at.from.angle_rad * (1.0 - at.share) + at.to.angle_rad * at.share);
    }
    return between(attitude_of(at.from.axis, at.from.angle_rad), attitude_of(at.to.axis, at.to.angle_rad), at.share);
}

Camera camera_at(const Camera &camera, const EyeMotion &motion, double time_s) {
    const Point eye = place_at(motion.places, time_s);
    if (motion.view) {
        const EyeMotion::View &view = *motion.view;
        return Camera::look_at(eye, view.target, view.up, view.width, view.height);
    }
    Camera moved = camera;
    moved.eye = eye;
    return moved;
}

/// Times rise, and everything is a finite place.
template <typename Key, typename IsValid>
void check_keys(const std::vector<Key> &keys, const std::string &owner, SceneChecker &check, IsValid &&is_valid) {
    for (size_t i = 0; i < keys.size(); ++i) {
        const bool rises = i == 0 || keys[i].time_s > keys[i - 1].time_s;
        if (!std::isfinite(keys[i].time_s) || !rises) {
            check.complain(owner + ": the times of its keys do not rise");
        } else if (!is_valid(keys[i])) {
            check.complain(owner + ": key " + std::to_string(i) +
                           " is not finite, beyond 1e12, or turns about nothing");
        }
    }
}

bool is_valid_place(const PlaceKey &key) {
    return is_place(key.place);
}
bool is_valid_turn(const TurnKey &key) {
    return is_place(key.axis) && key.axis != Vector(0.0f) && std::isfinite(key.angle_rad);
}

} // namespace

void check_animation(const Animation &animation, const std::vector<Object> &objects, SceneChecker &check) {
    for (const ObjectMotion &motion : animation.objects) {
        if (motion.object >= objects.size()) {
            check.complain("an animation moves object " + std::to_string(motion.object) + " of " +
                           std::to_string(objects.size()));
            continue;
        }
        const Object &object = objects[motion.object];
        const std::string owner = surface_name("object", motion.object, object.name);
        if (!object.pose) check.complain(owner + ": is animated, but has no pose");
        if (!is_place(motion.pivot)) check.complain(owner + ": its pivot is not a finite place within 1e12");
        check_keys(motion.moves, owner, check, is_valid_place);
        check_keys(motion.turns, owner, check, is_valid_turn);
    }
    check_keys(animation.eye.places, "the eye", check, is_valid_place);
}

RigidTransform pose_at(const ObjectMotion &motion, double time_s) {
    const Attitude attitude = motion.turns.empty() ? Attitude{} : attitude_at(motion.turns, time_s);
    const Point moved_by = motion.moves.empty() ? Point(0.0f) : place_at(motion.moves, time_s);
    return pose_of(attitude, motion.pivot, moved_by);
}

Result<std::shared_ptr<const Scene>> scene_at(const std::shared_ptr<const Scene> &scene, const Animation &animation,
                                              double time_s) try {
    SceneChecker check;
    check_animation(animation, scene->objects(), check);
    if (!std::isfinite(time_s)) check.complain("the time is not finite");
    if (!check.ok()) return Error(ErrorCode::bad_input, check.take_diagnostics());

    std::vector<ObjectPose> poses;
    for (const ObjectMotion &motion : animation.objects) poses.push_back({motion.object, pose_at(motion, time_s)});
    Result<std::shared_ptr<const Scene>> moved = with_poses(scene, poses);
    if (!moved || animation.eye.places.empty()) return moved;

    SceneEdit edit(**moved);
    edit.camera() = camera_at(scene->camera(), animation.eye, time_s);
    if (const auto problem = camera_problem(edit.camera())) {
        return Error(ErrorCode::bad_input, "at " + std::to_string(time_s) + " s: " + *problem);
    }
    return edit.take();
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

Result<std::shared_ptr<const Scene>> scene_at(const std::shared_ptr<const Scene> &scene, double time_s) {
    if (!scene->animation()) return scene;
    return scene_at(scene, *scene->animation(), time_s);
}

} // namespace glint
