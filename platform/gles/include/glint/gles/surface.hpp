// Something to draw on with OpenGL ES that needs no window: a context, and a colour buffer one can read back.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glint/export.hpp>
#include <glint/result.hpp>

namespace glint::gles {

/// Finds an OpenGL entry point by its name ("glDrawArrays"); nullptr where there is none.
using ProcLoader = std::function<void *(const char *name)>;

/// An off-screen context and its colour buffer. It belongs to the thread that uses it: everything below, destruction
/// included, is for the thread in which the surface is current or for one in which it is current nowhere.
///
/// Surfaces of different kinds may live in one process and take turns; call make_current() at each turn.
class GLINT_API Surface {
public:
    virtual ~Surface();
    Surface(const Surface &) = delete;
    Surface &operator=(const Surface &) = delete;

    /// "egl-surfaceless", "egl-pbuffer" or "osmesa".
    [[nodiscard]] virtual std::string kind() const = 0;
    /// The context's GL_VERSION and GL_RENDERER.
    [[nodiscard]] virtual std::string gl_description() const = 0;
    [[nodiscard]] virtual uint32_t width_px() const = 0;
    [[nodiscard]] virtual uint32_t height_px() const = 0;

    /// Makes the context current in this thread and binds the surface's own colour buffer as the framebuffer.
    /// A surface is current when it was created.
    virtual Status make_current() = 0;
    /// Gives the surface another size, at least 1 x 1; its contents are undefined afterwards. Makes it current.
    /// Where the new size cannot be had, the old one stays.
    virtual Status resize(uint32_t width_px, uint32_t height_px) = 0;
    /// Finds the context's entry points; usable as long as the process runs.
    [[nodiscard]] virtual ProcLoader proc_loader() const = 0;
    /// glFinish: returns when everything drawn so far is in the colour buffer. The surface must be current.
    virtual void finish() = 0;
    /// The whole colour buffer: R, G, B, A bytes, rows without gaps, top row first. Makes the surface current.
    virtual Result<std::vector<uint8_t>> read_back() = 0;

protected:
    Surface() = default;
};

} // namespace glint::gles
