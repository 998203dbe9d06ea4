// A scene on a screen, moved through: the loop from events to pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <glint/accel.hpp>
#include <glint/renderer.hpp>
#include <glint/result.hpp>

#include "viewer/frame_log.hpp"
#include "viewer/script.hpp"
#include "viewer/window.hpp"

namespace glint::viewer {

struct ViewOptions {
    std::string name; ///< of the scene, for people
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Accel> accel;
    unsigned threads = 1; ///< that trace
    Isa isa = best_isa();
    uint32_t depth = 1; ///< at first
    Transfer transfer = Transfer::linear;

    /// Frames a second to hold, and not to go beyond. Unset: the display's, as fast as can be where there is none; 60
    /// are held.
    std::optional<double> fps;
    bool shows_figures = true; ///< at first

    std::optional<Script> script;
    std::optional<uint64_t> frames;                     ///< ends after so many
    bool ends_at_rest = false;                          ///< ends once the script is over and the picture is final
    std::optional<std::filesystem::path> screenshot;    ///< of the last frame, when it ends
    std::optional<std::filesystem::path> record_folder; ///< for every frame; then the clock goes by frames
    std::filesystem::path screenshot_folder = ".";      ///< for those that a key asks for
    /// Called with every line for the person who watches the terminal.
    std::function<void(const std::string &)> say = [](const std::string &) {};
    std::function<bool()> is_interrupted = [] { return false; }; ///< ends once it says so
};

/// Runs until it is closed, interrupted, or has shown what was asked for. Fails with what cannot be mended: no new
/// context for a lost one, no memory for a picture, a picture that cannot be written.
[[nodiscard]] Result<FrameLog> view(Window &window, ViewOptions options);

} // namespace glint::viewer
