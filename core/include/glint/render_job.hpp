// A render that goes on while its caller does other things.
#pragma once

#include <cstdint>
#include <memory>

#include <glint/export.hpp>
#include <glint/result.hpp>

namespace glint {

/// What one render did.
struct RenderStatistics {
    double seconds = 0.0;
    uint64_t primary_rays = 0;
    uint64_t shadow_rays = 0;
    uint64_t secondary_rays = 0; ///< mirrored and transmitted
    [[nodiscard]] uint64_t rays() const { return primary_rays + shadow_rays + secondary_rays; }
};

/// One picture on its way, from Renderer::start(). The renderer and the framebuffer must outlive the job; the
/// framebuffer may be read meanwhile, by who does not mind tiles that are half written, and must not be written to.
///
///     glint::Result<glint::RenderJob> job = renderer.start(picture);
///     while (!job->is_done()) show(job->progress());
///     glint::Result<glint::RenderStatistics> result = job->wait();
///
/// Movable, not copyable. progress(), cancel() and is_done() may be called from any thread while the job is neither
/// moved nor destroyed; wait() from one at a time.
class GLINT_API RenderJob {
public:
    /// Cancels the render, and waits until nothing of it works any more.
    ~RenderJob();
    RenderJob(RenderJob &&other) noexcept;
    /// Cancels the job that it was, and waits for it, as the destructor does.
    RenderJob &operator=(RenderJob &&other) noexcept;

    /// Finished share of the picture, in [0, 1].
    [[nodiscard]] double progress() const;
    /// Stops the render within one tile's work. Does not wait for that, and does nothing to a render that is over.
    void cancel();
    /// Whether the render is over, so that wait() returns at once. On threads of a host that runs no tasks it is never
    /// true before wait() was called.
    [[nodiscard]] bool is_done() const;
    /// Helps to trace, where that is the quicker way or the only one, and returns when the render is over and on_done
    /// has returned: with what it did, or with `cancelled` or `out_of_memory`. A cancelled framebuffer holds whole
    /// tiles, the rest untouched. Every further call returns the same.
    [[nodiscard]] Result<RenderStatistics> wait();

private:
    friend class Renderer;
    struct State;
    explicit RenderJob(std::shared_ptr<State> state);
    void stop();

    std::shared_ptr<State> state_; ///< shared with tasks that may begin late; nullptr once moved from
};

} // namespace glint
