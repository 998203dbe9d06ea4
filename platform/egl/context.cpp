// Finding a display, a configuration and a context.
#include "egl/context.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace glint::egl {

namespace {

/// An initialised display. Without DISPLAY or WAYLAND_DISPLAY the default one fails, so platforms that need neither go
/// first: Mesa's surfaceless one, then (other vendors) the first device.
std::optional<EGLDisplay> open_display(const Egl &egl) {
    std::vector<EGLDisplay> candidates;
    const auto add_platform = [&](EGLenum platform, const char *extension) {
        if (egl.get_platform_display == nullptr || !egl.has_client_extension(extension)) return;
        candidates.push_back(egl.get_platform_display(platform, EGL_DEFAULT_DISPLAY, nullptr));
    };
    add_platform(EGL_PLATFORM_SURFACELESS_MESA, "EGL_MESA_platform_surfaceless");
    add_platform(EGL_PLATFORM_DEVICE_EXT, "EGL_EXT_platform_device");
    candidates.push_back(egl.get_display(EGL_DEFAULT_DISPLAY));
    for (EGLDisplay display : candidates) {
        if (display != EGL_NO_DISPLAY && egl.initialize(display, nullptr, nullptr) == EGL_TRUE) return display;
    }
    return std::nullopt;
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
    const std::optional<EGLDisplay> display = open_display(egl);
    if (!display) {
        Error error = egl.error("eglInitialize");
        error.diagnostics.front().hint = Egl::default_names().install_hint;
        return error;
    }
    if (egl.bind_api(EGL_OPENGL_ES_API) != EGL_TRUE) return egl.error("eglBindAPI");
    struct Version {
        EGLint major, renderable_bit;
    };
    for (const Version version : {Version{3, EGL_OPENGL_ES3_BIT_KHR}, Version{2, EGL_OPENGL_ES2_BIT}}) {
        const std::optional<EGLConfig> config = choose_config(egl, *display, version.renderable_bit);
        if (!config) continue;
        const std::array<EGLint, 3> attributes = {EGL_CONTEXT_CLIENT_VERSION, version.major, EGL_NONE};
        const EGLContext context = egl.create_context(*display, *config, EGL_NO_CONTEXT, attributes.data());
        if (context != EGL_NO_CONTEXT) return Context(egl, *display, *config, context);
    }
    Error error = egl.error("eglCreateContext");
    error.diagnostics.front().hint = Egl::default_names().install_hint;
    return error;
}

Context::Context(Context &&other) noexcept
    : egl_(other.egl_),
      display_(other.display_),
      config_(other.config_),
      context_(std::exchange(other.context_, EGL_NO_CONTEXT)) {}

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
