// Shows pictures whatever becomes of the context: the pixels in memory are the truth, everything else can be made anew.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include <glint/export.hpp>
#include <glint/gles/presenter.hpp>

namespace glint::gles {

/// One picture of a frame: what, where and how.
struct Layer {
    PixelView picture;
    /// The rectangle, as Presenter::draw() takes it.
    int x = 0, y = 0, width_px = 0, height_px = 0;
    DrawOptions how;
    /// The pixels are uploaded when this is another number than last time, or the context is a new one. 0: always.
    uint64_t version = 0;
};

/// How frames are shown.
struct ShowOptions {
    /// glFinish after uploading and after drawing, so that their times mean something. Costs what overlap there was.
    bool finish = false;
};

/// Where the time of a frame went, in seconds. Without ShowOptions::finish drivers may do the work later.
struct ShowTimes {
    double upload_s = 0.0; ///< of all layers
    double draw_s = 0.0;
};

/// A Presenter for each layer, in a context that may vanish at any moment. Used in one thread.
class GLINT_API ReliablePresenter {
public:
    /// Gives a context that works, current in this thread with a framebuffer bound, and the way to its entry points:
    /// the old context, or a new one where `lost`. Before a call with `lost` all that was in the old context is given
    /// up without calling OpenGL, so that the old one may be destroyed first.
    using ContextSource = std::function<Result<ProcLoader>(bool lost)>;

    explicit ReliablePresenter(ContextSource context);
    /// Deletes the GL objects where the context can still be made current.
    ~ReliablePresenter();
    ReliablePresenter(const ReliablePresenter &) = delete;
    ReliablePresenter &operator=(const ReliablePresenter &) = delete;

    /// Draws the layers, first to last. Where the context turns out to be lost, or cannot be made current any more, a
    /// new one is asked for, everything is made, uploaded and drawn again, once: then the failure is reported, and the
    /// next call begins with a new context.
    Result<ShowTimes> show(std::span<const Layer> layers, const ShowOptions &options = {});

    /// Somebody else found out that the context is lost (eglSwapBuffers said EGL_CONTEXT_LOST, or the window is gone):
    /// the next show() asks for a new one.
    void context_was_lost();

    /// How often a context had to be given up so far.
    [[nodiscard]] uint64_t losses() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace glint::gles
