// What the `animate_` directives of a scene file say.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <glint/animation.hpp>

#include "text/problems.hpp"

namespace glint {

/// An `animate_object` line.
struct ObjectKeyDraft {
    enum class Kind : uint8_t { translate, rotate, pivot };

    Kind kind;
    std::string_view name; ///< of the object, or the number of its line
    Place place;           ///< of the name
    float time_s = 0.0f;   ///< not of a pivot
    Place time_place = {};
    glm::vec3 value{0.0f}; ///< a place, or an axis
    float degrees = 0.0f;  ///< of a turn
    size_t object = 0;     ///< number of the object's line, from 0; known once the whole file was read
};

/// An `animate_eye` line.
struct EyeKeyDraft {
    float time_s;
    Place time_place;
    Point eye;
    Place place; ///< of z
};

struct MotionDraft {
    std::vector<ObjectKeyDraft> objects;
    std::vector<EyeKeyDraft> eye;
};

struct SceneDraft;

/// Finds the objects that the lines name, lets them move, and checks that times rise.
void check_motion(SceneDraft &draft, Problems &problems);
/// The animation that the lines make together; nullptr where there are none. After check_motion() found no problem.
[[nodiscard]] std::shared_ptr<const Animation> animation_of(const SceneDraft &draft);

} // namespace glint
