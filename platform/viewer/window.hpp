// Where frames are shown and input comes from.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

#include "viewer/input.hpp"

namespace glint::viewer {

/// Used in the thread that made it.
class Window {
public:
    virtual ~Window();
    Window(const Window &) = delete;
    Window &operator=(const Window &) = delete;

    /// "window (x11)", "egl-pbuffer" and the like.
    [[nodiscard]] virtual std::string kind() const = 0;
    /// The context's GL_VERSION and GL_RENDERER.
    [[nodiscard]] virtual std::string gl_description() const = 0;
    /// What there is to draw on, in pixels.
    [[nodiscard]] virtual uint32_t width_px() const = 0;
    [[nodiscard]] virtual uint32_t height_px() const = 0;
    /// Pixels for each unit in which the desktop counts: 2 on displays of twice the usual density.
    [[nodiscard]] virtual double density() const { return 1.0; }
    /// Pictures a second that the display shows; 0 where there is none.
    [[nodiscard]] virtual double refresh_rate() const { return 0.0; }
    virtual void set_title(const std::string &) {}

    /// Appends what has happened; where that is nothing, waits up to so many seconds for something to happen.
    virtual void take_events(double wait_s, std::vector<InputEvent> &events) = 0;
    /// Another size, as when a script asks for it. An event tells when it is there.
    virtual Status resize(uint32_t width_px, uint32_t height_px) = 0;

    /// As gles::ReliablePresenter::ContextSource: a context that is current, a new one where the old one is lost.
    virtual Result<gles::ProcLoader> context(bool is_lost) = 0;
    /// Shows what was drawn; fails where the context turns out to be lost.
    virtual Status swap() = 0;
    /// What was drawn since the last swap(): R, G, B, A bytes, the top row first.
    virtual Result<std::vector<uint8_t>> read_back() = 0;

protected:
    Window() = default;
};

/// No window at all: an off-screen surface of EGL or OSMesa, and no input but what a script brings.
[[nodiscard]] Result<std::unique_ptr<Window>> open_offscreen(uint32_t width_px, uint32_t height_px);

/// A window on the desktop, through SDL2, with the size told in the desktop's units. Fails with `unsupported`, saying
/// how to go on, where there is no SDL2, no display or no OpenGL ES.
[[nodiscard]] Result<std::unique_ptr<Window>> open_on_desktop(const std::string &title, uint32_t width,
                                                              uint32_t height);

} // namespace glint::viewer
