// Fingers on a screen: one orbits, two move and pinch.
#include "viewer/touch.hpp"

#include <algorithm>
#include <cmath>

namespace glint::viewer {

TouchMove Touch::handle(const InputEvent &event) {
    const auto finger =
        std::find_if(fingers_.begin(), fingers_.end(), [&](const Finger &f) { return f.id == event.finger; });
    const bool is_known = finger != fingers_.end();
    if (event.kind == InputEvent::Kind::finger_down && !is_known) {
        fingers_.push_back({event.finger, event.x, event.y});
    } else if (event.kind == InputEvent::Kind::finger_up && is_known) {
        fingers_.erase(finger);
    } else if (event.kind == InputEvent::Kind::finger_move && is_known) {
        const std::vector<Finger> before = fingers_;
        finger->x = event.x;
        finger->y = event.y;
        if (fingers_.size() == 1) {
            return {TouchMove::Kind::one, before[0].x, before[0].y, event.x, event.y, 1.0};
        }
        if (finger - fingers_.begin() > 1) return {};
        const auto middle = [](double a, double b) { return 0.5 * (a + b); };
        const auto distance = [](const std::vector<Finger> &f) { return std::hypot(f[1].x - f[0].x, f[1].y - f[0].y); };
        // Fingers that touch each other say nothing about a factor.
        constexpr double least_px = 1.0;
        const double spread = std::max(distance(fingers_), least_px) / std::max(distance(before), least_px);
        return {TouchMove::Kind::two,
                middle(before[0].x, before[1].x),
                middle(before[0].y, before[1].y),
                middle(fingers_[0].x, fingers_[1].x),
                middle(fingers_[0].y, fingers_[1].y),
                spread};
    }
    return {};
}

} // namespace glint::viewer
