// An OpenGL ES context made through EGL, before there is anything to draw on.
#pragma once

#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

#include "egl/library.hpp"

namespace glint::egl {

/// Owns an EGL context. Its display is the process's: EGL gives every caller the same one and eglTerminate would end
/// them all, so it is initialised here and never terminated.
class Context {
public:
    /// Prefers displays that need no display server, and OpenGL ES 3 over 2. Not current yet. Fails with `unsupported`.
    [[nodiscard]] static Result<Context> create(const Egl &egl);
    /// The same on a given display, which is initialised; `gles_version` is 2 or 3, and newer contexts may come.
    [[nodiscard]] static Result<Context> create_on(const Egl &egl, EGLDisplay display, int gles_version);
    ~Context();
    Context(Context &&other) noexcept;
    Context &operator=(Context &&other) noexcept; ///< they trade places

    /// Without a surface the context is current with nothing to draw on, where the display allows that.
    Status make_current(EGLSurface surface = EGL_NO_SURFACE) const;
    [[nodiscard]] gles::ProcLoader proc_loader() const;
    /// Whether the display can have a context without a surface current.
    [[nodiscard]] bool has_surfaceless() const;

    [[nodiscard]] const Egl &egl() const { return egl_; }
    [[nodiscard]] EGLDisplay display() const { return display_; }
    [[nodiscard]] EGLConfig config() const { return config_; }

private:
    Context(const Egl &egl, EGLDisplay display, EGLConfig config, EGLContext context)
        : egl_(egl), display_(display), config_(config), context_(context) {}

    Egl egl_;
    EGLDisplay display_;
    EGLConfig config_;
    EGLContext context_;
};

} // namespace glint::egl
