// Loading libEGL and reading its answers.
#include "egl/library.hpp"

#include <array>
#include <cstdio>
#include <type_traits>

#include "gles/extension_list.hpp"

namespace glint::egl {

gles::LibraryNames Egl::default_names() {
    static constexpr std::array<const char *, 2> file_names = {"libEGL.so.1", "libEGL.so"};
    return {file_names, "install the packages libegl1 and libgl1-mesa-dri (Debian, Ubuntu), or choose another surface"};
}

Result<Egl> Egl::load(const gles::LibraryNames &names) {
    Result<gles::DynamicLibrary> library = gles::DynamicLibrary::open(names);
    if (!library) return std::move(library).error();
    Egl egl;
    Status status = Done{};
    const auto find = [&](auto &function, const char *name) {
        if (status) status = library->find(function, name);
    };
    find(egl.bind_api, "eglBindAPI");
    find(egl.choose_config, "eglChooseConfig");
    find(egl.create_context, "eglCreateContext");
    find(egl.create_pbuffer_surface, "eglCreatePbufferSurface");
    find(egl.destroy_context, "eglDestroyContext");
    find(egl.destroy_surface, "eglDestroySurface");
    find(egl.get_config_attrib, "eglGetConfigAttrib");
    find(egl.get_current_context, "eglGetCurrentContext");
    find(egl.get_display, "eglGetDisplay");
    find(egl.get_error, "eglGetError");
    find(egl.get_proc_address, "eglGetProcAddress");
    find(egl.initialize, "eglInitialize");
    find(egl.make_current, "eglMakeCurrent");
    find(egl.query_string, "eglQueryString");
    if (!status) return std::move(status).error();
    const auto find_extension = [&](auto &function, const char *name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(egl.get_proc_address(name));
    };
    if (egl.has_client_extension("EGL_EXT_platform_base")) {
        find_extension(egl.get_platform_display, "eglGetPlatformDisplayEXT");
    }
    const bool has_devices = egl.has_client_extension("EGL_EXT_device_base");
    if (has_devices || egl.has_client_extension("EGL_EXT_device_enumeration")) {
        find_extension(egl.query_devices, "eglQueryDevicesEXT");
    }
    if (has_devices || egl.has_client_extension("EGL_EXT_device_query")) {
        find_extension(egl.query_device_string, "eglQueryDeviceStringEXT");
    }
    return egl;
}

bool Egl::has_client_extension(const char *name) const {
    const char *list = query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (list != nullptr) return gles::lists_extension(list, name);
    get_error(); // EGL 1.4 without client extensions complains; nobody else should hear it
    return false;
}

bool Egl::has_display_extension(EGLDisplay display, const char *name) const {
    const char *list = query_string(display, EGL_EXTENSIONS);
    return list != nullptr && gles::lists_extension(list, name);
}

Error Egl::error(const char *call) const {
    const EGLint code = get_error();
    const bool no_room = code == EGL_BAD_ALLOC;
    // eglGetDisplay and eglChooseConfig report this way that they found nothing.
    if (code == EGL_SUCCESS) return Error(ErrorCode::unsupported, std::string(call) + " found none");
    return Error(no_room ? ErrorCode::limit_exceeded : ErrorCode::unsupported,
                 std::string(call) + " failed with " + error_name(code));
}

std::string error_name(EGLint code) {
    // The codes follow each other from EGL_SUCCESS on.
    static constexpr std::array names = {
        "EGL_SUCCESS",       "EGL_NOT_INITIALIZED", "EGL_BAD_ACCESS",        "EGL_BAD_ALLOC",
        "EGL_BAD_ATTRIBUTE", "EGL_BAD_CONFIG",      "EGL_BAD_CONTEXT",       "EGL_BAD_CURRENT_SURFACE",
        "EGL_BAD_DISPLAY",   "EGL_BAD_MATCH",       "EGL_BAD_NATIVE_PIXMAP", "EGL_BAD_NATIVE_WINDOW",
        "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",     "EGL_CONTEXT_LOST",
    };
    static_assert(EGL_SUCCESS + names.size() - 1 == EGL_CONTEXT_LOST);
    if (code >= EGL_SUCCESS && code <= EGL_CONTEXT_LOST) return names[static_cast<size_t>(code - EGL_SUCCESS)];
    char text[24];
    std::snprintf(text, sizeof text, "error 0x%04X", static_cast<unsigned>(code));
    return text;
}

} // namespace glint::egl
