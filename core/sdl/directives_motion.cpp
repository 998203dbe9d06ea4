// The directives that move objects and the eye. What they make together, motion_draft.cpp says.
#include <cmath>

#include "sdl/arguments.hpp"
#include "sdl/directives.hpp"
#include "sdl/scene_draft.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

using Kind = ObjectKeyDraft::Kind;

/// Seconds.
float read_time(const Arguments &arguments, size_t i) {
    return arguments.number(i, -1e6f, 1e6f);
}

/// Whether the word of a form that counts so many arguments is the right one; the count says which that is.
bool has_word(const Arguments &arguments, size_t i, std::string_view word) {
    if (arguments.word(i) == word) return true;
    arguments.error(
        i, words("expected ", in_quotes(word), ", found ", in_quotes(arguments.word(i))),
        "after the time, 'translate' takes three numbers, 'rotate' an axis and degrees; 'pivot' has no time");
    return false;
}

ObjectKeyDraft key_of(Kind kind, const Arguments &arguments, size_t first) {
    ObjectKeyDraft key;
    key.kind = kind;
    key.name = arguments.word(0);
    key.place = arguments.place(0);
    if (kind != Kind::pivot) {
        key.time_s = read_time(arguments, 1);
        key.time_place = arguments.place(1);
    }
    key.value = arguments.point(first);
    return key;
}

} // namespace

void read_object_move(const Arguments &arguments, SceneDraft &draft) {
    if (has_word(arguments, 2, "translate")) draft.motion.objects.push_back(key_of(Kind::translate, arguments, 3));
}

void read_object_turn(const Arguments &arguments, SceneDraft &draft) {
    if (!has_word(arguments, 2, "rotate")) return;
    ObjectKeyDraft key = key_of(Kind::rotate, arguments, 3);
    if (key.value == glm::vec3(0.0f)) arguments.error(3, "the axis is zero");
    key.degrees = arguments.number(6, -1e6f, 1e6f);
    draft.motion.objects.push_back(key);
}

void read_object_pivot(const Arguments &arguments, SceneDraft &draft) {
    if (has_word(arguments, 1, "pivot")) draft.motion.objects.push_back(key_of(Kind::pivot, arguments, 2));
}

void read_eye_move(const Arguments &arguments, SceneDraft &draft) {
    draft.motion.eye.push_back({read_time(arguments, 0), arguments.place(0), arguments.point(1), arguments.place(3)});
}

} // namespace glint
