// A camera that a person moves: around things, along the picture, towards what the cursor points at, in flight.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <glint/export.hpp>
#include <glint/scene.hpp>

namespace glint {

/// Turns what a person does with a mouse, fingers and keys into cameras.
///
/// Places in the window are fractions of it: (0, 0) is its top left corner, (1, 1) its lower right one. The camera
/// keeps its window's shape in space through all moves, so one whose window lies off its axis, as SDL's may, stays so.
///
/// It turns around its pivot: at first the middle of the objects' bounds where that is in the picture, else a place
/// ahead. Upwards is the coordinate axis nearest to the first camera's own. A move that would lead beyond
/// max_coordinate, or whose numbers are not finite, is not made. One thread at a time calls it.
class GLINT_API CameraControl {
public:
    /// Begins with the scene's camera. The size in pixels (each at least 1) is that of a picture which this camera
    /// fills as it is, without widening; by default the scene's own.
    explicit CameraControl(std::shared_ptr<const Scene> scene);
    CameraControl(std::shared_ptr<const Scene> scene, uint32_t width_px, uint32_t height_px);

    /// For RenderOptions::camera. The scene's own to the bit until something moves it, and after reset(), in a window
    /// of the shape it was made for.
    [[nodiscard]] Camera camera() const;

    /// Around the pivot, by a drag of so much of the window: its whole width is a turn, its whole height half a turn.
    /// Stops short of the poles.
    void orbit(glm::dvec2 drag);

    /// Along the picture, so that the place under the cursor `from` comes to lie under `to`. That place is so far from
    /// the eye, in the scene's units, as the ray through `from` hits something; unset = as deep as the pivot.
    void pan(glm::dvec2 from, glm::dvec2 to, std::optional<double> distance = std::nullopt);

    /// Brings the place under the cursor nearer, and the pivot with it, so that both are `factor` of their distance
    /// away, factor > 0; it stays under the cursor. `distance` as in pan(). Ends at 1e-5 and 1e3 times the scene's
    /// radius from the pivot.
    void zoom(glm::dvec2 cursor, double factor, std::optional<double> distance = std::nullopt);

    /// Flies for some time: velocities to the right, upwards and ahead, as the camera sees them, in scene radii a
    /// second.
    void fly(glm::dvec3 velocity, double seconds);

    /// Back to the scene's camera.
    void reset();

    /// Moves, without turning, so that the bounds of all objects lie in the picture, framed by frame_margin of it at
    /// the sides where they are tightest; turns around their middle from now on. Does nothing where objects have no
    /// bounds.
    void frame();
    static constexpr double frame_margin = 0.05;

    /// The window has another shape: what is seen from top to bottom stays, on the sides there is more or less. A shape
    /// so long that the camera's window would reach beyond max_coordinate changes nothing.
    void resize(uint32_t width_px, uint32_t height_px);

    /// Where a point is seen: as a fraction of the window, which it may lie outside of; nothing for a point that is not
    /// in front of the eye.
    [[nodiscard]] std::optional<glm::dvec2> place_of(const glm::dvec3 &point) const;
    /// From the eye through a place of the window; of unit length.
    [[nodiscard]] glm::dvec3 direction_to(glm::dvec2 place) const;

    [[nodiscard]] const glm::dvec3 &eye() const { return state_.eye; }
    [[nodiscard]] const glm::dvec3 &pivot() const { return state_.pivot; }
    /// Half the diagonal of the objects' bounds, in the scene's units; of a scene without bounds the distance from the
    /// eye to its window.
    [[nodiscard]] double scene_radius() const { return radius_; }

private:
    /// All that moves. The columns of `window` lead from the eye to the window's top left corner, and along its upper
    /// and its left edge, in the shape it was made for.
    struct State {
        glm::dvec3 eye, pivot;
        glm::dmat3 window;
        bool is_moved = false;
    };

    [[nodiscard]] glm::dmat3 widened() const;
    /// How deep a place lies under the cursor, in window depths.
    [[nodiscard]] double depth_at(glm::dvec2 place, std::optional<double> distance) const;
    void move_to(const State &next);

    std::shared_ptr<const Scene> scene_;
    uint32_t width_px_, height_px_;
    double widening_ = 1.0;
    glm::dvec3 lo_{0.0}, hi_{0.0}; ///< the objects' bounds
    bool has_bounds_ = false;
    double radius_ = 1.0;
    glm::dvec3 up_{0.0, 1.0, 0.0};
    State first_, state_;
};

} // namespace glint
