// From `animate_` directives to an animation.
#include "sdl/motion_draft.hpp"

#include <optional>
#include <string>

#include "sdl/camera_draft.hpp"
#include "sdl/scene_draft.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

using Kind = ObjectKeyDraft::Kind;

/// The line's number among the object lines, from 0, where the word is one; beyond all where it is too large.
std::optional<size_t> line_number(std::string_view word) {
    size_t number = 0;
    for (const char c : word) {
        if (c < '0' || c > '9') return std::nullopt;
        if (number < 1'000'000'000) number = number * 10 + static_cast<size_t>(c - '0');
    }
    return number - 1; // of 0 too
}

/// Whether the object, or one of the materials of a model, is called so.
bool is_called(const ObjectDraft &entry, std::string_view name) {
    if (entry.parts.empty()) return false;
    const std::string_view full = entry.parts[0].name;
    return full == name || (entry.from_mtl && full.starts_with(name) && full.substr(name.size()).starts_with(':'));
}

/// Sets the key's object, or tells why there is none.
void resolve(ObjectKeyDraft &key, const SceneDraft &draft, Problems &problems) {
    const size_t count = draft.objects.size();
    const auto complain = [&](std::string message, std::string hint) {
        problems.error(key.place, std::move(message), std::move(hint));
    };
    if (const auto number = line_number(key.name)) {
        key.object = *number;
        if (*number < count) return;
        return complain(words("there is no object ", in_quotes(key.name)),
                        words("objects are numbered from 1 to ", count, " by their lines"));
    }
    size_t found = 0;
    for (size_t i = 0; i < count; ++i) {
        if (!is_called(draft.objects[i], key.name)) continue;
        if (found++ == 0) key.object = i;
    }
    if (found == 1) return;
    if (found > 1) {
        return complain(words(found, " objects are called ", in_quotes(key.name)),
                        "say which by its number: object lines count from 1");
    }
    for (const LightDraft &entry : draft.lights) {
        if (entry.light.name == key.name) {
            return complain(words(in_quotes(key.name), " is a light, and lights do not move"), {});
        }
    }
    complain(words("there is no object ", in_quotes(key.name)),
             "the name is that of the object's file, or its line's number among the objects, from 1");
}

/// Keys of one thing come in the order of their times.
void check_rising(std::optional<float> &last, float time_s, const Place &place, Problems &problems) {
    if (last && !(time_s > *last)) problems.error(place, "the times of a motion's lines do not rise");
    last = time_s;
}

/// What the lines so far have said of an object.
struct Said {
    std::optional<float> moved_s, turned_s; ///< last
    uint32_t pivot_line = 0;
};

} // namespace

void check_motion(SceneDraft &draft, Problems &problems) {
    std::vector<Said> said(draft.motion.objects.empty() ? 0 : draft.objects.size());
    for (ObjectKeyDraft &key : draft.motion.objects) {
        key.object = said.size();
        resolve(key, draft, problems);
        if (key.object >= said.size()) continue;
        for (Object &object : draft.objects[key.object].parts) object.pose = RigidTransform{};
        Said &before = said[key.object];
        if (key.kind != Kind::pivot) {
            check_rising(key.kind == Kind::translate ? before.moved_s : before.turned_s, key.time_s, key.time_place,
                         problems);
        } else if (before.pivot_line != 0) {
            problems.error(key.place, words("the pivot was given already, on line ", before.pivot_line));
        } else {
            before.pivot_line = key.place.line;
        }
    }
    std::optional<float> last;
    const std::optional<Given<Point>> eye = draft.eye;
    for (const EyeKeyDraft &key : draft.motion.eye) {
        check_rising(last, key.time_s, key.time_place, problems);
        if (!eye) continue; // told of already
        draft.eye = {key.eye, key.place};
        (void)camera_of(draft, problems); // tells why the eye cannot be there
    }
    draft.eye = eye;
}

std::shared_ptr<const Animation> animation_of(const SceneDraft &draft) {
    constexpr double radians = 3.141592653589793 / 180.0;
    if (draft.motion.objects.empty() && draft.motion.eye.empty()) return nullptr;
    std::vector<ObjectMotion> motions(draft.objects.size()); // by line
    for (const ObjectKeyDraft &key : draft.motion.objects) {
        ObjectMotion &motion = motions[key.object];
        if (key.kind == Kind::translate) {
            motion.moves.push_back({key.time_s, key.value});
        } else if (key.kind == Kind::rotate) {
            motion.turns.push_back({key.time_s, key.value, double(key.degrees) * radians});
        } else {
            motion.pivot = key.value;
        }
    }
    auto animation = std::make_shared<Animation>();
    uint32_t object = 0;
    for (size_t line = 0; line < draft.objects.size(); ++line) {
        for (const Object &part : draft.objects[line].parts) {
            motions[line].object = object++;
            if (part.pose) animation->objects.push_back(motions[line]);
        }
    }
    for (const EyeKeyDraft &key : draft.motion.eye) animation->eye.places.push_back({key.time_s, key.eye});
    if (draft.target) animation->eye.view = view_of(draft);
    return animation;
}

} // namespace glint
