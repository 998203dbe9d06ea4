// What EGL offers on this machine, and why what is missing is missing.
#pragma once

#include <string>
#include <vector>

#include <glint/export.hpp>
#include <glint/gles/context_facts.hpp>

namespace glint::egl {

/// A context of one version of OpenGL ES on a display.
struct GlesSurvey {
    int version = 0;          ///< asked for: 2 or 3
    std::string missing;      ///< why there is none; empty where there is one
    gles::ContextFacts facts; ///< where there is one
};

/// A display that EGL may find.
struct DisplaySurvey {
    std::string platform;              ///< "surfaceless", "device 0", "x11", "wayland", "default"
    std::string detail;                ///< of a device: its file, or "software"
    std::string missing;               ///< why there is none; empty where there is one
    std::string hint;                  ///< what to do about that; may be empty
    std::string version;               ///< EGL_VERSION
    std::string vendor;                ///< EGL_VENDOR
    bool surfaceless_contexts = false; ///< contexts can be current without a surface
    std::vector<GlesSurvey> gles;      ///< 3, then 2
};

/// Everything that EGL offers.
struct Survey {
    std::string missing; ///< why there is no EGL at all; empty where there is
    std::string hint;    ///< what to install then
    std::vector<std::string> client_extensions;
    std::vector<DisplaySurvey> displays;

    /// Whether any context can be had.
    [[nodiscard]] GLINT_API bool has_context() const;
};

/// Tries everything. Afterwards no context is current in this thread. X11 and Wayland are tried only where DISPLAY or
/// WAYLAND_DISPLAY says that there is a server.
[[nodiscard]] GLINT_API Survey survey();

} // namespace glint::egl
