// A window on the desktop, through SDL2.
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "gles/gl.hpp"
#include "gles/offscreen_target.hpp"
#include "viewer/sdl2_events.hpp"
#include "viewer/window.hpp"

namespace glint::viewer {

namespace {

class Sdl2Window final : public Window {
public:
    Sdl2Window(const Sdl2 &sdl, SDL_Window *window) : sdl_(sdl), window_(window) { measure(); }

    ~Sdl2Window() override {
        if (context_ != nullptr) sdl_.gl_delete_context(context_);
        sdl_.destroy_window(window_);
        sdl_.quit_sub_system(SDL_INIT_VIDEO);
    }

    [[nodiscard]] std::string kind() const override {
        const char *driver = sdl_.get_current_video_driver();
        return std::string("window (") + (driver != nullptr ? driver : "unknown") + ")";
    }
    [[nodiscard]] std::string gl_description() const override { return gl_ ? gl_->description() : "no context"; }
    [[nodiscard]] uint32_t width_px() const override { return width_px_; }
    [[nodiscard]] uint32_t height_px() const override { return height_px_; }
    [[nodiscard]] double density() const override { return density_; }
    void set_title(const std::string &title) override { sdl_.set_window_title(window_, title.c_str()); }

    [[nodiscard]] double refresh_rate() const override {
        SDL_DisplayMode mode{};
        const int display = sdl_.get_window_display_index(window_);
        if (display < 0 || sdl_.get_current_display_mode(display, &mode) != 0) return 0.0;
        return mode.refresh_rate;
    }

    void take_events(double wait_s, std::vector<InputEvent> &events) override {
        SDL_Event event;
        const bool waits = wait_s >= 0.001; // SDL counts in milliseconds
        bool has_event = waits ? sdl_.wait_event_timeout(&event, static_cast<int>(wait_s * 1000.0)) != 0
                               : sdl_.poll_event(&event) != 0;
        for (; has_event; has_event = sdl_.poll_event(&event) != 0) {
            if (event.type == SDL_MOUSEWHEEL) {
                events.push_back(wheel(event.wheel));
            } else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
                measure();
                InputEvent resize;
                resize.kind = InputEvent::Kind::resize;
                resize.width_px = width_px_;
                resize.height_px = height_px_;
                events.push_back(resize);
            } else if (const auto input = input_of(event, {width_px_, height_px_, density_})) {
                if (input->kind == InputEvent::Kind::move) cursor_ = *input;
                events.push_back(*input);
            }
        }
    }

    Status resize(uint32_t width_px, uint32_t height_px) override {
        const auto units = [&](uint32_t px) { return static_cast<int>(std::lround(px / density_)); };
        sdl_.set_window_size(window_, units(width_px), units(height_px));
        return Done{};
    }

    Result<gles::ProcLoader> context(bool is_lost) override {
        if (is_lost && context_ != nullptr) {
            sdl_.gl_delete_context(std::exchange(context_, nullptr));
            gl_.reset();
        }
        const gles::ProcLoader loader = [get = sdl_.gl_get_proc_address](const char *name) { return get(name); };
        if (context_ == nullptr) {
            context_ = sdl_.gl_create_context(window_);
            if (context_ == nullptr) return sdl_.error("SDL_GL_CreateContext");
            sdl_.gl_set_swap_interval(1);
        }
        if (sdl_.gl_make_current(window_, context_) != 0) return sdl_.error("SDL_GL_MakeCurrent");
        if (!gl_) {
            Result<gles::Gl> gl = gles::Gl::load(loader);
            if (!gl) return gl.error();
            gl_ = std::move(*gl);
        }
        return loader;
    }

    Status swap() override {
        sdl_.gl_swap_window(window_);
        return Done{};
    }

    Result<std::vector<uint8_t>> read_back() override {
        if (!gl_) return Error(ErrorCode::unsupported, "there is no context to read from");
        return gles::read_rgba8(*gl_, width_px_, height_px_);
    }

private:
    void measure() {
        int width = 1, height = 1, width_px = 1, height_px = 1;
        sdl_.get_window_size(window_, &width, &height);
        sdl_.gl_get_drawable_size(window_, &width_px, &height_px);
        width_px_ = static_cast<uint32_t>(std::max(width_px, 1));
        height_px_ = static_cast<uint32_t>(std::max(height_px, 1));
        density_ = static_cast<double>(width_px_) / std::max(width, 1);
    }

    /// A wheel turns where the cursor is, which its event does not say.
    [[nodiscard]] InputEvent wheel(const SDL_MouseWheelEvent &turned) const {
        InputEvent event = cursor_;
        event.kind = InputEvent::Kind::wheel;
        event.amount = static_cast<double>(turned.preciseY);
        if (turned.direction == SDL_MOUSEWHEEL_FLIPPED) event.amount = -event.amount;
        return event;
    }

    Sdl2 sdl_;
    SDL_Window *window_;
    SDL_GLContext context_ = nullptr;
    std::optional<gles::Gl> gl_; // of the context
    uint32_t width_px_ = 1, height_px_ = 1;
    double density_ = 1.0;
    InputEvent cursor_; // where it was last
};

/// A window whose surface suits OpenGL ES of that version, with its context; nullptr where there is none.
SDL_Window *create_window(const Sdl2 &sdl, const std::string &title, int width, int height, int version) {
    const std::pair<SDL_GLattr, int> wanted[] = {
        {SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES},
        {SDL_GL_CONTEXT_MAJOR_VERSION, version},
        {SDL_GL_CONTEXT_MINOR_VERSION, 0},
        {SDL_GL_RED_SIZE, 8},
        {SDL_GL_GREEN_SIZE, 8},
        {SDL_GL_BLUE_SIZE, 8},
        {SDL_GL_ALPHA_SIZE, 0},
        {SDL_GL_DEPTH_SIZE, 0},
        {SDL_GL_STENCIL_SIZE, 0},
        {SDL_GL_DOUBLEBUFFER, 1},
    };
    for (const auto &[attribute, value] : wanted) sdl.gl_set_attribute(attribute, value);
    return sdl.create_window(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                             SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
}

} // namespace

Result<std::unique_ptr<Window>> open_on_desktop(const std::string &title, uint32_t width, uint32_t height) {
    const Result<Sdl2> sdl = Sdl2::load();
    if (!sdl) return sdl.error();
    // OpenGL ES as everywhere else; touches as touches; SIGINT as the program has it.
    sdl->set_hint(SDL_HINT_OPENGL_ES_DRIVER, "1");
    sdl->set_hint(SDL_HINT_VIDEO_X11_FORCE_EGL, "1");
    sdl->set_hint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");
    sdl->set_hint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    sdl->set_hint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    if (sdl->init_sub_system(SDL_INIT_VIDEO) != 0) {
        Error error(ErrorCode::unsupported,
                    std::string("there is no display to open a window on (") + sdl->get_error() + ")");
        error.diagnostics.front().hint = "go on without a window: --surface offscreen";
        return error;
    }
    for (const int version : {3, 2}) {
        SDL_Window *const handle =
            create_window(*sdl, title, static_cast<int>(width), static_cast<int>(height), version);
        if (handle == nullptr) continue;
        auto window = std::make_unique<Sdl2Window>(*sdl, handle);
        if (window->context(false)) return std::unique_ptr<Window>(std::move(window));
        sdl->init_sub_system(SDL_INIT_VIDEO); // the window's end has ended it
    }
    Error error = sdl->error("making an OpenGL ES context for a window");
    error.diagnostics.front().hint =
        "install the packages libegl1 and libgl1-mesa-dri (Debian, Ubuntu), or go on without a window: --surface "
        "offscreen";
    sdl->quit_sub_system(SDL_INIT_VIDEO);
    return error;
}

} // namespace glint::viewer
