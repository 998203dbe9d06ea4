// A scene that moves by itself, at the moment that is to be shown.
#pragma once

#include <memory>

#include <glint/accel.hpp>
#include <glint/result.hpp>
#include <glint/scene.hpp>

namespace glint::viewer {

/// Follows a scene's animation: begins at time 0, and rests after its last key.
class Playback {
public:
    explicit Playback(std::shared_ptr<const Accel> accel, std::shared_ptr<const Scene> scene);

    /// Goes on to that time, in seconds. Whether what is shown has changed. Fails where the animation leads the camera
    /// to where no picture can be taken.
    [[nodiscard]] Result<bool> go_to(double time_s);

    [[nodiscard]] const std::shared_ptr<const Accel> &accel() const { return accel_; }
    [[nodiscard]] const std::shared_ptr<const Scene> &scene() const { return scene_; }
    [[nodiscard]] double time_s() const { return time_s_; }
    /// Time of the last key; 0 of a scene that does not move.
    [[nodiscard]] double end_s() const { return end_s_; }
    [[nodiscard]] bool is_over() const { return time_s_ >= end_s_; }
    [[nodiscard]] bool moves_eye() const { return moves_eye_; }

private:
    std::shared_ptr<const Accel> accel_;
    std::shared_ptr<const Scene> scene_;
    double time_s_ = 0.0, end_s_ = 0.0;
    bool moves_eye_ = false;
};

} // namespace glint::viewer
