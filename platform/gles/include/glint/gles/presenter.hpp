// Shows a picture through OpenGL ES: an RGBA8 texture on two triangles.
#pragma once

#include <memory>

#include <glint/export.hpp>
#include <glint/gles/pixel_view.hpp>
#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

namespace glint::gles {

/// What stands between a picture's pixels where the rectangle has another size. In its own size a picture is shown to
/// the byte with each of them.
enum class Filter {
    nearest,  ///< the nearest pixel: large squares
    bilinear, ///< the four around, by distance
    sharp, ///< the twelve around, weighted along edges: fewer stairs, narrower lines. A little nearer to the picture in
           ///< full than bilinear, ten times as dear, which a graphics processor does not notice and a software
           ///< driver does (docs/performance.md). Where a side shrinks, bilinear
};

/// How a picture meets what the framebuffer holds.
enum class Blend {
    replace,       ///< it is overwritten, alpha too
    straight,      ///< shines through where alpha is below 255; the picture's colours are as they are
    premultiplied, ///< the same, the picture's colours are multiplied by alpha already
};

/// How a picture is drawn.
struct DrawOptions {
    Filter filter = Filter::bilinear;
    Blend blend = Blend::replace;
};

/// Draws pictures with whatever OpenGL ES context is current; it knows no window. It needs OpenGL ES 2.0 and uses
/// what newer contexts have; a desktop core profile that takes ES 2.0 shaders serves too. Several presenters share a
/// context: a heads-up display is one more, drawn with blending over the picture.
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

    /// Copies the picture (a Framebuffer or any other RGBA8 pixels) to the texture, whose storage is made anew only
    /// when the size changes. A picture larger than the context's textures may be goes to several. Sizes need be no
    /// powers of two: without mipmaps and repetition OpenGL ES 2.0 takes them all. Fails with bad_input when there are
    /// no pixels.
    Status upload(const PixelView &picture);
    /// Fills a rectangle of the current framebuffer with the picture last uploaded, its top row at the rectangle's
    /// top. (x, y) is the rectangle's lower left corner in OpenGL's window coordinates. Pixels arrive unchanged where
    /// the rectangle has the picture's size and blends with nothing; otherwise `how` says what comes between them. An
    /// empty rectangle draws nothing.
    Status draw(int x, int y, int width_px, int height_px, const DrawOptions &how = {});
    /// Whether the context says that it is lost (the graphics processor was reset, for instance). Only contexts that
    /// tell (OpenGL ES 3.2, GL_KHR_robustness, GL_EXT_robustness) ever do. Nothing can be shown any more then:
    /// abandon(), make a new context and in it a new presenter; ReliablePresenter does all that.
    [[nodiscard]] bool context_lost() const;
    /// The context is gone: forgets the GL names without calling GL. Afterwards upload() and draw() fail.
    void abandon();

private:
    struct Impl;
    explicit Presenter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace glint::gles
