// SDL2's events as ours.
#include "viewer/sdl2_events.hpp"

namespace glint::viewer {

namespace {

/// Flying goes by where keys are, so that it is the same cluster on every keyboard; all else by what is written on
/// them.
std::optional<Key> key_of(const SDL_Keysym &key) {
    switch (key.scancode) {
    case SDL_SCANCODE_W:
        return Key::w;
    case SDL_SCANCODE_A:
        return Key::a;
    case SDL_SCANCODE_S:
        return Key::s;
    case SDL_SCANCODE_D:
        return Key::d;
    case SDL_SCANCODE_Q:
        return Key::q;
    case SDL_SCANCODE_E:
        return Key::e;
    default:
        break;
    }
    if (key.sym >= SDLK_0 && key.sym <= SDLK_9) {
        return static_cast<Key>(static_cast<int>(Key::digit0) + (key.sym - SDLK_0));
    }
    switch (key.sym) {
    case SDLK_r:
        return Key::r;
    case SDLK_f:
        return Key::f;
    case SDLK_p:
        return Key::p;
    case SDLK_h:
        return Key::h;
    case SDLK_LSHIFT:
    case SDLK_RSHIFT:
        return Key::shift;
    case SDLK_SPACE:
        return Key::space;
    case SDLK_TAB:
        return Key::tab;
    case SDLK_ESCAPE:
        return Key::escape;
    case SDLK_PLUS:
    case SDLK_EQUALS: // the same key, without Shift
    case SDLK_KP_PLUS:
        return Key::plus;
    case SDLK_MINUS:
    case SDLK_KP_MINUS:
        return Key::minus;
    case SDLK_UP:
        return Key::up;
    case SDLK_DOWN:
        return Key::down;
    case SDLK_KP_0:
        return Key::digit0;
    case SDLK_KP_1:
        return Key::digit1;
    case SDLK_KP_2:
        return Key::digit2;
    case SDLK_KP_3:
        return Key::digit3;
    case SDLK_KP_4:
        return Key::digit4;
    case SDLK_KP_5:
        return Key::digit5;
    case SDLK_KP_6:
        return Key::digit6;
    case SDLK_KP_7:
        return Key::digit7;
    case SDLK_KP_8:
        return Key::digit8;
    case SDLK_KP_9:
        return Key::digit9;
    default:
        return std::nullopt;
    }
}

std::optional<Button> button_of(uint8_t button) {
    switch (button) {
    case SDL_BUTTON_LEFT:
        return Button::left;
    case SDL_BUTTON_MIDDLE:
        return Button::middle;
    case SDL_BUTTON_RIGHT:
        return Button::right;
    default:
        return std::nullopt;
    }
}

} // namespace

std::optional<InputEvent> input_of(const SDL_Event &event, const WindowScale &scale) {
    InputEvent input;
    const auto at = [&](double x, double y) {
        // The middle of the pixel that the cursor points at.
        input.x = (x + 0.5) * scale.density;
        input.y = (y + 0.5) * scale.density;
    };
    switch (event.type) {
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP: {
        const std::optional<Button> button = button_of(event.button.button);
        if (!button) return std::nullopt;
        input.kind = event.type == SDL_MOUSEBUTTONDOWN ? InputEvent::Kind::button_down : InputEvent::Kind::button_up;
        input.button = *button;
        at(event.button.x, event.button.y);
        return input;
    }
    case SDL_MOUSEMOTION:
        input.kind = InputEvent::Kind::move;
        at(event.motion.x, event.motion.y);
        return input;
    case SDL_FINGERDOWN:
    case SDL_FINGERMOTION:
    case SDL_FINGERUP:
        input.kind = event.type == SDL_FINGERDOWN     ? InputEvent::Kind::finger_down
                     : event.type == SDL_FINGERMOTION ? InputEvent::Kind::finger_move
                                                      : InputEvent::Kind::finger_up;
        input.finger = static_cast<uint64_t>(event.tfinger.fingerId);
        input.x = static_cast<double>(event.tfinger.x) * scale.width_px; // told as fractions of the window
        input.y = static_cast<double>(event.tfinger.y) * scale.height_px;
        return input;
    case SDL_KEYDOWN:
    case SDL_KEYUP: {
        const std::optional<Key> key = key_of(event.key.keysym);
        const bool repeats = key == Key::up || key == Key::down;
        if (!key || (event.key.repeat != 0 && !repeats)) return std::nullopt;
        input.kind = event.type == SDL_KEYDOWN ? InputEvent::Kind::key_down : InputEvent::Kind::key_up;
        input.key = *key;
        return input;
    }
    case SDL_WINDOWEVENT:
        if (event.window.event != SDL_WINDOWEVENT_EXPOSED) return std::nullopt;
        input.kind = InputEvent::Kind::redraw;
        return input;
    case SDL_QUIT:
        input.kind = InputEvent::Kind::close;
        return input;
    default:
        return std::nullopt;
    }
}

} // namespace glint::viewer
