// What a person does to a window, wherever it comes from: a display server, a touch screen or a script.
#pragma once

#include <cstdint>
#include <string_view>

namespace glint::viewer {

enum class Button : uint8_t { left, middle, right };

/// The keys that mean something here.
enum class Key : uint8_t {
    w,
    a,
    s,
    d,
    q,
    e,
    r,
    f,
    p,
    h,
    shift,
    space,
    tab,
    escape,
    plus,
    minus,
    up,
    down,
    digit0,
    digit1,
    digit2,
    digit3,
    digit4,
    digit5,
    digit6,
    digit7,
    digit8,
    digit9,
};

/// One event. Places are pixels of the picture on the screen, (0, 0) its top left corner.
struct InputEvent {
    enum class Kind : uint8_t {
        button_down,
        button_up,
        move,  ///< of the cursor
        wheel, ///< `amount` notches, away from the person where positive
        finger_down,
        finger_move,
        finger_up,
        key_down, ///< once, however long it is held
        key_up,
        resize,       ///< to width_px x height_px
        redraw,       ///< what was on the screen is gone
        context_lost, ///< the graphics context is gone, or is to be given up
        close,
    };

    Kind kind = Kind::redraw;
    double x = 0.0, y = 0.0;
    double amount = 0.0;
    Button button = Button::left;
    Key key = Key::w;
    uint64_t finger = 0; ///< which one
    uint32_t width_px = 0, height_px = 0;
};

} // namespace glint::viewer
