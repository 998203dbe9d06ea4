// A window that nobody sees.
#include <chrono>
#include <thread>
#include <utility>

#include <glint/egl/surface.hpp>
#include <glint/osmesa/surface.hpp>

#include "viewer/window.hpp"

namespace glint::viewer {

Window::~Window() = default;

namespace {

Result<std::unique_ptr<gles::Surface>> open_surface(uint32_t width_px, uint32_t height_px) {
    // The pbuffer first: drivers have fast paths for window-system surfaces that a framebuffer object lacks.
    if (auto pbuffer = egl::create_pbuffer(width_px, height_px)) return pbuffer;
    auto surfaceless = egl::create_surfaceless(width_px, height_px);
    if (surfaceless) return surfaceless;
    if (auto off_screen = osmesa::create(width_px, height_px)) return off_screen;
    return surfaceless;
}

class OffscreenWindow final : public Window {
public:
    explicit OffscreenWindow(std::unique_ptr<gles::Surface> surface)
        : surface_(std::move(surface)),
          kind_(surface_->kind()),
          gl_description_(surface_->gl_description()),
          width_px_(surface_->width_px()),
          height_px_(surface_->height_px()) {}

    [[nodiscard]] std::string kind() const override { return kind_; }
    [[nodiscard]] std::string gl_description() const override { return gl_description_; }
    [[nodiscard]] uint32_t width_px() const override { return width_px_; }
    [[nodiscard]] uint32_t height_px() const override { return height_px_; }

    void take_events(double wait_s, std::vector<InputEvent> &events) override {
        if (is_resized_) {
            InputEvent event;
            event.kind = InputEvent::Kind::resize;
            event.width_px = width_px_;
            event.height_px = height_px_;
            events.push_back(event);
            is_resized_ = false;
        } else if (wait_s > 0.0) {
            std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
        }
    }

    Status resize(uint32_t width_px, uint32_t height_px) override {
        if (surface_) {
            if (Status resized = surface_->resize(width_px, height_px); !resized) return resized;
        }
        is_resized_ = width_px != width_px_ || height_px != height_px_;
        width_px_ = width_px;
        height_px_ = height_px;
        return Done{};
    }

    Result<gles::ProcLoader> context(bool is_lost) override {
        if (is_lost) surface_.reset();
        if (surface_) {
            if (Status current = surface_->make_current(); !current) return current.error();
        } else {
            auto surface = open_surface(width_px_, height_px_);
            if (!surface) return surface.error();
            surface_ = std::move(*surface);
        }
        return surface_->proc_loader();
    }

    Status swap() override {
        if (surface_) surface_->finish();
        return Done{};
    }

    Result<std::vector<uint8_t>> read_back() override {
        if (!surface_) return Error(ErrorCode::unsupported, "there is no surface to read from");
        return surface_->read_back();
    }

private:
    std::unique_ptr<gles::Surface> surface_; // nullptr between the loss of one and the making of the next
    std::string kind_, gl_description_;
    uint32_t width_px_, height_px_;
    bool is_resized_ = false;
};

} // namespace

Result<std::unique_ptr<Window>> open_offscreen(uint32_t width_px, uint32_t height_px) {
    auto surface = open_surface(width_px, height_px);
    if (!surface) return surface.error();
    return std::unique_ptr<Window>(std::make_unique<OffscreenWindow>(std::move(*surface)));
}

} // namespace glint::viewer
