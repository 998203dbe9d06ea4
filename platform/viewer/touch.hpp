// Fingers on a screen: one orbits, two move and pinch.
#pragma once

#include <cstdint>
#include <vector>

#include "viewer/input.hpp"

namespace glint::viewer {

/// What the fingers did with one event. Places and lengths are pixels.
struct TouchMove {
    enum class Kind : uint8_t {
        none,
        one, ///< a single finger moved from `from` to `to`
        two, ///< the middle of two fingers moved likewise, and their distance grew to `spread` times what it was
    };
    Kind kind = Kind::none;
    double from_x = 0.0, from_y = 0.0, to_x = 0.0, to_y = 0.0;
    double spread = 1.0;
};

/// Keeps track of the fingers. The first two count; a third waits until one of them leaves.
class Touch {
public:
    /// What a finger event means; `none` for other events.
    [[nodiscard]] TouchMove handle(const InputEvent &event);
    [[nodiscard]] bool touched() const { return !fingers_.empty(); }

private:
    struct Finger {
        uint64_t id;
        double x, y;
    };
    std::vector<Finger> fingers_; // in the order in which they came
};

} // namespace glint::viewer
