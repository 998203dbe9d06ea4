// libEGL, looked up at run time: a program starts without it, and can say what is missing.
#pragma once

#include <string>

#include <glint/result.hpp>

#include "gles/dynamic_library.hpp"

// No prototypes, so that none is linked by accident; no native types, so that X11's headers are not needed.
#define EGL_EGL_PROTOTYPES 0
#define EGL_NO_X11
#include <EGL/egl.h>
// After egl.h, whose types it uses.
#include <EGL/eglext.h>

namespace glint::egl {

/// The functions of EGL 1.4 that this room calls, and some of extensions. Plain data; usable while the process runs.
struct Egl {
    /// Fails with `unsupported`, naming what to install, when there is no such library or it is not libEGL.
    [[nodiscard]] static Result<Egl> load(const gles::LibraryNames &names = default_names());
    /// Where EGL is found on Linux and Android.
    [[nodiscard]] static gles::LibraryNames default_names();

    /// Whether EGL itself, rather than one display, has the extension.
    [[nodiscard]] bool has_client_extension(const char *name) const;
    [[nodiscard]] bool has_display_extension(EGLDisplay display, const char *name) const;
    /// The failure of `call`, with the code that eglGetError has for it.
    [[nodiscard]] Error error(const char *call) const;

    PFNEGLBINDAPIPROC bind_api = nullptr;
    PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
    PFNEGLCREATECONTEXTPROC create_context = nullptr;
    PFNEGLCREATEPBUFFERSURFACEPROC create_pbuffer_surface = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
    PFNEGLDESTROYSURFACEPROC destroy_surface = nullptr;
    PFNEGLGETCONFIGATTRIBPROC get_config_attrib = nullptr;
    PFNEGLGETCURRENTCONTEXTPROC get_current_context = nullptr;
    PFNEGLGETDISPLAYPROC get_display = nullptr;
    PFNEGLGETERRORPROC get_error = nullptr;
    PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLMAKECURRENTPROC make_current = nullptr;
    PFNEGLQUERYSTRINGPROC query_string = nullptr;

    // nullptr where EGL has none.
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
    PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;
};

/// "EGL_BAD_ALLOC" and the like; other codes in hexadecimal.
[[nodiscard]] std::string error_name(EGLint code);

} // namespace glint::egl
