// What input means: which events move the camera, and which change how the picture is made.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include <glint/camera_control.hpp>

#include "viewer/hud/hud.hpp"
#include "viewer/input.hpp"
#include "viewer/touch.hpp"

namespace glint::viewer {

/// A pixel of the picture on the screen, from its top left corner.
struct PixelPlace {
    uint32_t x = 0, y = 0;
    friend bool operator==(const PixelPlace &, const PixelPlace &) = default;
};

/// What a person has chosen so far.
struct ViewChoices {
    uint32_t depth = 0;
    unsigned threads = 1;
    bool is_paused = false;
    bool shows_figures = true;
    bool shows_help = false;
    std::optional<PixelPlace> inspected; ///< whose ray tree is shown
    uint32_t first_ray = 0;              ///< rows of it that were scrolled away
    uint32_t screenshots = 0;            ///< asked for so far
    bool closes = false;
};

/// The keys and drags there are, for the help page.
[[nodiscard]] std::span<const HudKey> help_lines();

/// Turns events into moves of a camera and into choices.
class Controls {
public:
    /// How far from the eye something is at a place of the window, told as a fraction of it; nothing where nothing is.
    using DistanceAt = std::function<std::optional<double>(double x, double y)>;

    /// The camera must live as long as this. The size is the window's, in pixels.
    Controls(CameraControl &camera, ViewChoices choices, DistanceAt distance_at, uint32_t width_px, uint32_t height_px);

    void handle(const InputEvent &event);
    /// Flies on for so many seconds with the keys that are held.
    void advance(double seconds);

    [[nodiscard]] const ViewChoices &choices() const { return choices_; }
    /// Changes with every move of the camera.
    [[nodiscard]] uint64_t moves() const { return moves_; }
    /// Whether the camera was moved since the beginning, or since it went back.
    [[nodiscard]] bool has_moved_camera() const { return has_moved_camera_; }
    /// Whether keys are held by which every moment moves the camera.
    [[nodiscard]] bool is_flying() const;
    /// Whether a button, finger or key is held that moves the camera: more moves are to be expected.
    [[nodiscard]] bool is_moving() const;

private:
    /// Ways that are held, -1 to 1 each.
    struct Flight {
        double right, up, ahead;
    };
    [[nodiscard]] Flight flight() const;

    void begin_drag(const InputEvent &event);
    void drag_to(double x, double y);
    void end_drag();
    void touch(const TouchMove &move);
    void press(Key key);
    void zoom(double x, double y, double notches);
    void moved(bool by_hand = true);

    struct Drag {
        Button button;
        double start_x, start_y, x, y;
        bool is_click = true; // until it has moved further than a hand trembles
        std::optional<double> distance;
    };

    CameraControl &camera_;
    ViewChoices choices_;
    DistanceAt distance_at_;
    double width_px_, height_px_;
    double cursor_x_, cursor_y_;
    std::optional<Drag> drag_;
    Touch touch_;
    uint64_t held_ = 0; // keys, by bit
    uint64_t moves_ = 0;
    bool has_moved_camera_ = false;
};

} // namespace glint::viewer
