// Shows a framebuffer through OpenGL ES: one RGBA8 texture on two triangles.
#pragma once

#include <memory>

#include <glint/export.hpp>
#include <glint/framebuffer.hpp>
#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

namespace glint::gles {

/// Draws framebuffers with whatever OpenGL ES context is current; it knows no window. It needs OpenGL ES 2.0 and uses
/// what newer contexts have; a desktop core profile that takes ES 2.0 shaders serves too.
///
/// Every call needs the context that was current at create(), in the thread where it is current. The context's state
/// is after each call what it was before, save for texture and buffer names in use. State that a context keeps for
/// each draw buffer (blending, colour mask) is taken to be the same for all of them.
///
/// A call fails, naming the OpenGL call and the error's code, when OpenGL reports an error; an error that was pending
/// before is reported as such and cleared, and the call can be repeated.
class GLINT_API Presenter {
public:
    /// Fails with `unsupported` when no context is current or it lacks what OpenGL ES 2.0 has.
    [[nodiscard]] static Result<std::unique_ptr<Presenter>> create(const ProcLoader &load);
    /// Deletes the GL objects: the context must be current, unless abandon() was called.
    ~Presenter();
    Presenter(const Presenter &) = delete;
    Presenter &operator=(const Presenter &) = delete;

    /// Copies the 8-bit picture to the texture, whose storage is made anew only when the size changes. Fails with
    /// limit_exceeded when the picture is larger than the context's textures may be.
    Status upload(const Framebuffer &picture);
    /// Fills a rectangle of the current framebuffer with the picture last uploaded, its top row at the rectangle's
    /// top. (x, y) is the rectangle's lower left corner in OpenGL's window coordinates. Pixels arrive unchanged where
    /// the rectangle has the picture's size; otherwise they are interpolated. An empty rectangle draws nothing.
    Status draw(int x, int y, int width_px, int height_px);
    /// The context is gone: forgets the GL names without calling GL. Afterwards upload() and draw() fail.
    void abandon();

private:
    struct Impl;
    explicit Presenter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace glint::gles
