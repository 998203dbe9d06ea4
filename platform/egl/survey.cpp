// Trying all of EGL's displays and contexts.
#include <glint/egl/survey.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "egl/context.hpp"
#include "egl/display.hpp"

namespace glint::egl {

namespace {

/// The variable that names the server of a platform; nullptr where there is no server.
const char *server_variable(EGLenum platform) {
    if (platform == EGL_PLATFORM_X11_EXT) return "DISPLAY";
    return platform == EGL_PLATFORM_WAYLAND_EXT ? "WAYLAND_DISPLAY" : nullptr;
}

constexpr const char *server_hint = "start a server (Xvfb will do for X11), or draw off screen";
constexpr const char *default_hint = "the default display needs a server; off screen the others serve as well";

std::vector<std::string> words_of(std::string_view list) {
    std::vector<std::string> words;
    while (!list.empty()) {
        const size_t end = std::min(list.find(' '), list.size());
        if (end > 0) words.emplace_back(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return words;
}

std::string text_of(const char *text) {
    return text != nullptr ? text : "";
}

/// A pbuffer of one pixel, for contexts that must have a surface.
class Pixel {
public:
    explicit Pixel(const Context &context) : egl_(context.egl()), display_(context.display()) {
        constexpr std::array<EGLint, 5> attributes = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        if (context.has_surfaceless()) return;
        surface_ = egl_.create_pbuffer_surface(display_, context.config(), attributes.data());
    }
    ~Pixel() {
        if (surface_ != EGL_NO_SURFACE) egl_.destroy_surface(display_, surface_);
    }
    Pixel(const Pixel &) = delete;
    Pixel &operator=(const Pixel &) = delete;
    [[nodiscard]] EGLSurface surface() const { return surface_; }

private:
    const Egl &egl_;
    EGLDisplay display_;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

Result<gles::ContextFacts> facts_of(const Egl &egl, EGLDisplay display, int version) {
    const Result<Context> context = Context::create_on(egl, display, version);
    if (!context) return context.error();
    const Pixel pixel(*context);
    if (Status status = context->make_current(pixel.surface()); !status) return std::move(status).error();
    return gles::describe_context(context->proc_loader());
}

DisplaySurvey survey_display(const Egl &egl, const DisplayRoute &route) {
    DisplaySurvey result;
    result.platform = route.name;
    result.detail = route.detail;
    const char *variable = server_variable(route.platform);
    const char *server = variable != nullptr ? std::getenv(variable) : nullptr;
    if (variable != nullptr && server == nullptr) {
        result.missing = std::string(variable) + " is not set: there is no server to show windows on";
        result.hint = server_hint;
        return result;
    }
    const Result<EGLDisplay> display = open_display(egl, route);
    if (!display) {
        result.missing = display.error().diagnostics.front().message;
        result.hint = Egl::default_names().install_hint;
        if (server != nullptr) result.hint = std::string(variable) + " is '" + server + "'; " + server_hint;
        if (route.platform == 0) result.hint = default_hint;
        return result;
    }
    result.version = text_of(egl.query_string(*display, EGL_VERSION));
    result.vendor = text_of(egl.query_string(*display, EGL_VENDOR));
    result.surfaceless_contexts = egl.has_display_extension(*display, "EGL_KHR_surfaceless_context");
    for (const int version : {3, 2}) {
        Result<gles::ContextFacts> facts = facts_of(egl, *display, version);
        GlesSurvey &gles = result.gles.emplace_back();
        gles.version = version;
        if (facts)
            gles.facts = std::move(facts).value();
        else
            gles.missing = facts.error().diagnostics.front().message;
    }
    return result;
}

} // namespace

bool Survey::has_context() const {
    const auto works = [](const GlesSurvey &gles) { return gles.missing.empty(); };
    return std::any_of(displays.begin(), displays.end(), [&](const DisplaySurvey &display) {
        return std::any_of(display.gles.begin(), display.gles.end(), works);
    });
}

Survey survey() {
    Survey result;
    const Result<Egl> egl = Egl::load();
    if (!egl) {
        result.missing = egl.error().diagnostics.front().message;
        result.hint = Egl::default_names().install_hint;
        return result;
    }
    result.client_extensions = words_of(text_of(egl->query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS)));
    if (result.client_extensions.empty()) egl->get_error(); // EGL 1.4 complains; nobody else should hear it
    for (const DisplayRoute &route : all_routes(*egl)) result.displays.push_back(survey_display(*egl, route));
    return result;
}

} // namespace glint::egl
