// The displays that EGL knows ways to.
#pragma once

#include <string>
#include <vector>

#include "egl/library.hpp"

namespace glint::egl {

/// A way to a display. The platform's display need not be there.
struct DisplayRoute {
    std::string name;       ///< "surfaceless", "device 0", "x11", "wayland", "default"
    EGLenum platform = 0;   ///< 0: eglGetDisplay
    void *native = nullptr; ///< what the platform calls its display; nullptr: its default
    std::string detail;     ///< of a device: its file, or what kind it is
};

/// The ways that need no display server, best first, then the default one: Mesa's surfaceless platform, the first
/// device (other vendors), and whatever eglGetDisplay finds.
[[nodiscard]] std::vector<DisplayRoute> off_screen_routes(const Egl &egl);

/// Every way that there could be, also those that EGL has no extension for.
[[nodiscard]] std::vector<DisplayRoute> all_routes(const Egl &egl);

/// Finds and initialises the display. Fails with `unsupported`, naming the call and its code.
[[nodiscard]] Result<EGLDisplay> open_display(const Egl &egl, const DisplayRoute &route);

} // namespace glint::egl
