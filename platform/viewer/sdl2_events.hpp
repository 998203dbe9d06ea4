// SDL2's events as ours.
#pragma once

#include <optional>

#include "viewer/input.hpp"
#include "viewer/sdl2.hpp"

namespace glint::viewer {

/// The window's size in pixels, and pixels for each unit of SDL's coordinates.
struct WindowScale {
    uint32_t width_px, height_px;
    double density;
};

/// What the event means; nothing for those that mean nothing here. A window's new size is for the caller to find out.
[[nodiscard]] std::optional<InputEvent> input_of(const SDL_Event &event, const WindowScale &scale);

} // namespace glint::viewer
