// Finding displays.
#include "egl/display.hpp"

#include <algorithm>
#include <array>

#include "gles/extension_list.hpp"

namespace glint::egl {

namespace {

/// The extension without which EGL does not know the platform.
const char *extension_of(EGLenum platform) {
    switch (platform) {
    case EGL_PLATFORM_SURFACELESS_MESA:
        return "EGL_MESA_platform_surfaceless";
    case EGL_PLATFORM_DEVICE_EXT:
        return "EGL_EXT_platform_device";
    case EGL_PLATFORM_X11_EXT:
        return "EGL_EXT_platform_x11";
    case EGL_PLATFORM_WAYLAND_EXT:
        return "EGL_EXT_platform_wayland";
    default:
        return nullptr;
    }
}

bool knows(const Egl &egl, EGLenum platform) {
    const char *extension = extension_of(platform);
    if (extension == nullptr) return true;
    if (egl.get_platform_display == nullptr) return false;
    if (egl.has_client_extension(extension)) return true;
    // The same platforms under the names that Khronos gave them later, with the same numbers.
    return (platform == EGL_PLATFORM_X11_EXT && egl.has_client_extension("EGL_KHR_platform_x11")) ||
           (platform == EGL_PLATFORM_WAYLAND_EXT && egl.has_client_extension("EGL_KHR_platform_wayland"));
}

/// "/dev/dri/card0" or "software"; empty where EGL does not say.
std::string describe_device(const Egl &egl, EGLDeviceEXT device) {
    if (egl.query_device_string == nullptr) return {};
    const char *extensions = egl.query_device_string(device, EGL_EXTENSIONS);
    if (extensions == nullptr) return {};
    if (gles::lists_extension(extensions, "EGL_EXT_device_drm")) {
        if (const char *file = egl.query_device_string(device, EGL_DRM_DEVICE_FILE_EXT)) return file;
    }
    return gles::lists_extension(extensions, "EGL_MESA_device_software") ? "software" : "";
}

std::vector<DisplayRoute> device_routes(const Egl &egl) {
    constexpr EGLint most_devices = 64;
    std::array<EGLDeviceEXT, most_devices> devices = {};
    EGLint count = 0;
    if (egl.query_devices == nullptr || egl.query_devices(most_devices, devices.data(), &count) != EGL_TRUE) count = 0;
    if (count == 0) return {{"device", EGL_PLATFORM_DEVICE_EXT, nullptr, {}}};
    std::vector<DisplayRoute> routes;
    for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
        routes.push_back(
            {"device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT, devices[i], describe_device(egl, devices[i])});
    }
    return routes;
}

} // namespace

std::vector<DisplayRoute> off_screen_routes(const Egl &egl) {
    std::vector<DisplayRoute> routes = {{"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, nullptr, {}},
                                        {"device", EGL_PLATFORM_DEVICE_EXT, nullptr, {}},
                                        {"default", 0, nullptr, {}}};
    const auto unknown = [&egl](const DisplayRoute &route) { return !knows(egl, route.platform); };
    routes.erase(std::remove_if(routes.begin(), routes.end(), unknown), routes.end());
    return routes;
}

std::vector<DisplayRoute> all_routes(const Egl &egl) {
    std::vector<DisplayRoute> routes = {{"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, nullptr, {}}};
    for (DisplayRoute &device : device_routes(egl)) routes.push_back(std::move(device));
    routes.push_back({"x11", EGL_PLATFORM_X11_EXT, nullptr, {}});
    routes.push_back({"wayland", EGL_PLATFORM_WAYLAND_EXT, nullptr, {}});
    routes.push_back({"default", 0, nullptr, {}});
    return routes;
}

Result<EGLDisplay> open_display(const Egl &egl, const DisplayRoute &route) {
    if (!knows(egl, route.platform)) {
        return Error(ErrorCode::unsupported, std::string("EGL has no ") + extension_of(route.platform));
    }
    const bool is_default = route.platform == 0;
    const char *call = is_default ? "eglGetDisplay" : "eglGetPlatformDisplayEXT";
    const EGLDisplay display = is_default ? egl.get_display(EGL_DEFAULT_DISPLAY)
                                          : egl.get_platform_display(route.platform, route.native, nullptr);
    if (display == EGL_NO_DISPLAY) return egl.error(call);
    if (egl.initialize(display, nullptr, nullptr) != EGL_TRUE) return egl.error("eglInitialize");
    return display;
}

} // namespace glint::egl
