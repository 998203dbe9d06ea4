// The directives for the camera. What they make together, camera_draft.cpp says.
#include "sdl/arguments.hpp"
#include "sdl/directives.hpp"
#include "sdl/scene_draft.hpp"
#include "text/words.hpp"

namespace glint {

void read_eye(const Arguments &arguments, SceneDraft &draft) {
    draft.eye = {arguments.point(0), arguments.place(2)};
}

void read_target(const Arguments &arguments, SceneDraft &draft) {
    draft.target = {arguments.point(0), arguments.keyword_place()};
}

void read_up(const Arguments &arguments, SceneDraft &draft) {
    draft.up = {arguments.point(0), arguments.keyword_place()};
}

void read_window_size(const Arguments &arguments, SceneDraft &draft) {
    const auto length = [&](size_t i) { return arguments.number(i, 1e-6f, 1e6f); };
    draft.window_size = {{length(0), length(1)}, arguments.keyword_place()};
}

void read_fov(const Arguments &arguments, SceneDraft &draft) {
    draft.fov = {arguments.number(0, 0.001f, 179.0f), arguments.keyword_place()};
}

void read_ortho(const Arguments &arguments, SceneDraft &draft) {
    const auto coordinate = [&](size_t i) { return arguments.number(i, -max_coordinate, max_coordinate); };
    const Window window = {coordinate(0), coordinate(1), coordinate(2), coordinate(3)};
    if (window.x0 == window.x1) {
        arguments.error(2, words("the window has no width: x0 and x1 are both ", in_quotes(arguments.word(2))));
    }
    if (window.y0 == window.y1) {
        arguments.error(3, words("the window has no height: y0 and y1 are both ", in_quotes(arguments.word(3))));
    }
    draft.ortho = {window, arguments.keyword_place()};
}

} // namespace glint
