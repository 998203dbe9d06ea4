// A scene that moves by itself, at the moment that is to be shown.
#include "viewer/playback.hpp"

#include <algorithm>
#include <utility>

#include <glint/animation.hpp>

namespace glint::viewer {

Playback::Playback(std::shared_ptr<const Accel> accel, std::shared_ptr<const Scene> scene)
    : accel_(std::move(accel)), scene_(std::move(scene)) {
    const Animation *const animation = scene_->animation().get();
    if (animation == nullptr) return;
    const auto count = [&](const auto &keys) {
        if (!keys.empty()) end_s_ = std::max(end_s_, keys.back().time_s);
    };
    for (const ObjectMotion &motion : animation->objects) {
        count(motion.moves);
        count(motion.turns);
    }
    count(animation->eye.places);
    moves_eye_ = !animation->eye.places.empty();
}

Result<bool> Playback::go_to(double time_s) {
    time_s = std::min(time_s, end_s_);
    if (time_s == time_s_) return false;
    auto scene = scene_at(scene_, time_s);
    if (!scene) return scene.error();
    scene_ = std::move(*scene);
    accel_ = Accel::update(accel_, scene_);
    time_s_ = time_s;
    return true;
}

} // namespace glint::viewer
