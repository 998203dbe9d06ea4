// Finding a display, a configuration and a context.
#include "egl/context.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "egl/display.hpp"

namespace glint::egl {

namespace {

/// Without DISPLAY or WAYLAND_DISPLAY the default display fails, so those that need neither go first.
Result<EGLDisplay> open_off_screen_display(const Egl &egl) {
    std::string attempts;
    for (const DisplayRoute &route : off_screen_routes(egl)) {
        Result<EGLDisplay> display = open_display(egl, route);
        if (display) return display;
        attempts += (attempts.empty() ? "" : "; ") + route.name + ": " + display.error().diagnostics.front().message;
    }
    return Error(ErrorCode::unsupported, "no EGL display (" + attempts + ")", Egl::default_names().install_hint);
}

EGLint attribute(const Egl &egl, EGLDisplay display, EGLConfig config, EGLint name) {
    EGLint value = 0;
    egl.get_config_attrib(display, config, name, &value);
    return value;
}

/// A configuration of exactly 8 bits a channel (EGL sorts wider ones first) without multisampling, and with the
/// smallest depth and stencil buffers: those that nobody uses cost memory, and Mesa's llvmpipe its fast path.
std::optional<EGLConfig> choose_config(const Egl &egl, EGLDisplay display, EGLint renderable_bit) {
    const std::array<EGLint, 17> wanted = {EGL_SURFACE_TYPE,
                                           EGL_PBUFFER_BIT,
                                           EGL_RENDERABLE_TYPE,
                                           renderable_bit,
                                           EGL_RED_SIZE,
                                           8,
                                           EGL_GREEN_SIZE,
                                           8,
                                           EGL_BLUE_SIZE,
                                           8,
                                           EGL_ALPHA_SIZE,
                                           8,
                                           EGL_SAMPLE_BUFFERS,
                                           0,
                                           EGL_CONFORMANT,
                                           renderable_bit,
                                           EGL_NONE};
    EGLint count = 0;
    if (egl.choose_config(display, wanted.data(), nullptr, 0, &count) != EGL_TRUE || count <= 0) return std::nullopt;
    std::vector<EGLConfig> configs(static_cast<size_t>(count));
    if (egl.choose_config(display, wanted.data(), configs.data(), count, &count) != EGL_TRUE) return std::nullopt;
    configs.resize(static_cast<size_t>(count));

    std::optional<EGLConfig> best;
    EGLint best_extra_bits = 0;
    for (EGLConfig config : configs) {
        const auto bits = [&](EGLint name) { return attribute(egl, display, config, name); };
        const bool eight_bits_each = bits(EGL_RED_SIZE) == 8 && bits(EGL_GREEN_SIZE) == 8 && bits(EGL_BLUE_SIZE) == 8 &&
                                     bits(EGL_ALPHA_SIZE) == 8;
        const EGLint extra_bits = bits(EGL_DEPTH_SIZE) + bits(EGL_STENCIL_SIZE);
        if (!eight_bits_each || bits(EGL_SAMPLES) != 0 || (best && extra_bits >= best_extra_bits)) continue;
        best = config;
        best_extra_bits = extra_bits;
    }
    return best;
}

} // namespace

Result<Context> Context::create(const Egl &egl) {
    const Result<EGLDisplay> display = open_off_screen_display(egl);
    if (!display) return display.error();
    Result<Context> context = create_on(egl, *display, 3);
    if (!context) context = create_on(egl, *display, 2);
    return context;
}

Result<Context> Context::create_on(const Egl &egl, EGLDisplay display, int gles_version) {
    if (egl.bind_api(EGL_OPENGL_ES_API) != EGL_TRUE) return egl.error("eglBindAPI");
    const EGLint renderable_bit = gles_version >= 3 ? EGL_OPENGL_ES3_BIT_KHR : EGL_OPENGL_ES2_BIT;
    const std::optional<EGLConfig> config = choose_config(egl, display, renderable_bit);
    if (!config) {
        Error error = egl.error("eglChooseConfig");
        error.diagnostics.front().message +=
            ": pbuffers, 8 bits a channel, for OpenGL ES " + std::to_string(gles_version);
        return error;
    }
    // With a notification: a context that is lost with the graphics processor shall say so.
    const std::array<EGLint, 5> attributes = {EGL_CONTEXT_CLIENT_VERSION, gles_version,
                                              EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                                              EGL_LOSE_CONTEXT_ON_RESET_EXT, EGL_NONE};
    const std::array<EGLint, 3> plain_attributes = {EGL_CONTEXT_CLIENT_VERSION, gles_version, EGL_NONE};
    EGLContext context = EGL_NO_CONTEXT;
    if (egl.has_display_extension(display, "EGL_EXT_create_context_robustness")) {
        context = egl.create_context(display, *config, EGL_NO_CONTEXT, attributes.data());
        if (context == EGL_NO_CONTEXT) egl.get_error(); // drivers that promise it may still refuse
    }
    if (context == EGL_NO_CONTEXT) {
        context = egl.create_context(display, *config, EGL_NO_CONTEXT, plain_attributes.data());
    }
    if (context == EGL_NO_CONTEXT) {
        Error error = egl.error("eglCreateContext");
        error.diagnostics.front().hint = Egl::default_names().install_hint;
        return error;
    }
    return Context(egl, display, *config, context);
}

Context::Context(Context &&other) noexcept
    : egl_(other.egl_),
      display_(other.display_),
      config_(other.config_),
      context_(std::exchange(other.context_, EGL_NO_CONTEXT)) {}

Context &Context::operator=(Context &&other) noexcept {
    std::swap(egl_, other.egl_);
    std::swap(display_, other.display_);
    std::swap(config_, other.config_);
    std::swap(context_, other.context_);
    return *this;
}

Context::~Context() {
    if (context_ == EGL_NO_CONTEXT) return;
    if (egl_.get_current_context() == context_) {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    egl_.destroy_context(display_, context_);
}

Status Context::make_current(EGLSurface surface) const {
    if (egl_.make_current(display_, surface, surface, context_) != EGL_TRUE) return egl_.error("eglMakeCurrent");
    return Done{};
}

gles::ProcLoader Context::proc_loader() const {
    return [get_proc_address = egl_.get_proc_address](const char *name) {
        return reinterpret_cast<void *>(get_proc_address(name));
    };
}

bool Context::has_surfaceless() const {
    return egl_.has_display_extension(display_, "EGL_KHR_surfaceless_context");
}

} // namespace glint::egl
