// How objects and the eye move with time: keyframes, and the scene at a moment.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glint/export.hpp>
#include <glint/result.hpp>
#include <glint/scene.hpp>

namespace glint {

/// A place that is reached at a time. Between two keys the place goes straight and evenly from one to the other; before
/// the first and after the last it rests.
struct PlaceKey {
    double time_s = 0.0;
    Point place{0.0f};
};

/// A turn that is reached at a time. Between keys of the same axis the angle grows evenly, so that 0 to 4 pi is two
/// full turns; between others the object turns evenly from one attitude to the other, the shorter way.
struct TurnKey {
    double time_s = 0.0;
    Vector axis{0.0f, 1.0f, 0.0f}; ///< any length but 0
    double angle_rad = 0.0;        ///< counter-clockwise as seen from the axis' tip
};

/// How an object moves: it is turned about the pivot, then moved. Times of keys rise.
struct ObjectMotion {
    uint32_t object = 0; ///< into objects(), one that has a pose
    Point pivot{0.0f};   ///< in the object's own coordinates
    std::vector<PlaceKey> moves = {};
    std::vector<TurnKey> turns = {};
};

/// How the eye moves. Times of keys rise.
struct EyeMotion {
    /// What a camera that looks at something keeps in view (Camera::look_at()).
    struct View {
        Point target{0.0f};
        Vector up{0.0f, 1.0f, 0.0f};
        float width = 2.0f, height = 2.0f;
    };
    std::vector<PlaceKey> places;
    std::optional<View> view = std::nullopt; ///< without, the window stays where it is
};

/// All that moves with time.
struct Animation {
    std::vector<ObjectMotion> objects = {};
    EyeMotion eye = {};
};

/// Where the motion has the object at a time.
[[nodiscard]] GLINT_API RigidTransform pose_at(const ObjectMotion &motion, double time_s);

/// The scene at a time, of an animation that may be its own or another; objects that it does not move stay. Fails where
/// the animation moves what cannot move, a key is not finite, or the eye comes into the plane of its window or to its
/// target.
[[nodiscard]] GLINT_API Result<std::shared_ptr<const Scene>> scene_at(const std::shared_ptr<const Scene> &scene,
                                                                      const Animation &animation, double time_s);
/// The same, of the scene's own animation; a scene without is the same at all times.
[[nodiscard]] GLINT_API Result<std::shared_ptr<const Scene>> scene_at(const std::shared_ptr<const Scene> &scene,
                                                                      double time_s);

} // namespace glint
