// Tracing a scene into a framebuffer, on every core, watched and stoppable.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include <glint/accel.hpp>
#include <glint/export.hpp>
#include <glint/framebuffer.hpp>
#include <glint/host_threads.hpp>
#include <glint/isa.hpp>
#include <glint/render_job.hpp>
#include <glint/scene.hpp>

namespace glint {

/// Who traces.
struct RendererOptions {
    unsigned threads = 0; ///< that trace, the calling one included; 0 = one a processor
    Isa isa = best_isa(); ///< one of available_isas(); any other counts as Isa::scalar
    /// Lends the host's threads, `threads` - 1 of them a render. Empty = threads of the library's own.
    SubmitTask submit = {};
};

/// How the picture's linear colours become bytes.
enum class Transfer : uint8_t {
    linear, ///< round(255 c), as SDL's programs did
    srgb,   ///< by sRGB's transfer curve, as displays and other files expect
};

/// What to trace.
struct RenderOptions {
    /// Recursive rays in a row after the primary ray; unset = what the scene asks for.
    std::optional<uint32_t> max_depth = std::nullopt;
    /// Unset = the scene's own camera.
    std::optional<Camera> camera = std::nullopt;
    /// Samples a pixel, 1 to max_samples, and where they lie; unset = what the scene asks for.
    std::optional<uint32_t> samples_per_pixel = std::nullopt;
    std::optional<SamplePattern> pattern = std::nullopt;
    Transfer transfer = Transfer::linear;
    /// Only this one of the samples, below samples_per_pixel, row by row from the pixel's upper left; the picture is
    /// then its colour. Unset = all of them, averaged.
    std::optional<uint32_t> only_sample = std::nullopt;
};

/// Shared by a render in progress and whoever watches it, from any thread. Progress may be read and cancel() called at
/// any moment; cancel() stops the render within one tile's work. Use one control for one render at a time.
class GLINT_API RenderControl {
public:
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
    /// Finished share of the picture, in [0, 1].
    [[nodiscard]] double progress() const;
    /// Makes the control ready for another render.
    void reset();

private:
    friend class Tracing;
    std::atomic<bool> cancelled_{false};
    std::atomic<uint32_t> tiles_done_{0};
    std::atomic<uint32_t> tile_count_{0};
};

/// Traces pictures of one scene, with its own pool of threads or the host's. The pixels depend on the scene and the
/// RenderOptions alone, never on the number of threads. One render at a time a renderer: a second one waits, and helps
/// with the first where that was only started. Renderers do not know of each other and may run at the same time, also
/// on the same scene.
class GLINT_API Renderer {
public:
    /// Throws std::bad_alloc. Where the system gives fewer threads than asked for, those there are trace.
    explicit Renderer(std::shared_ptr<const Accel> accel, const RendererOptions &options = {});
    ~Renderer();
    Renderer(const Renderer &) = delete;
    Renderer &operator=(const Renderer &) = delete;

    /// Fills the framebuffer, of any size. Fails with `cancelled` when the control says so: then the framebuffer holds
    /// whole tiles, the rest untouched; fails with `bad_input` when the options' camera or samples are not valid, and
    /// with `out_of_memory`.
    [[nodiscard]] Result<RenderStatistics> render(Framebuffer &target, const RenderOptions &options = {},
                                                  RenderControl *control = nullptr);

    /// Begins to fill the framebuffer, of any size, and returns at once. Without a hook for the host's threads the
    /// library's own trace; with one, as many tasks are submitted as there are threads. Renderer and framebuffer must
    /// outlive the job.
    ///
    /// `on_done` is called once, when the picture is there or was given up, by whichever thread came to the end: one
    /// that traced, or one that waits for the job, maybe before start() returns. It may start the next render, must not
    /// wait for this job or destroy it, and what it throws is dropped.
    ///
    /// Fails as render() does, but for `cancelled`, which the job's wait() tells; then on_done is not called.
    [[nodiscard]] Result<RenderJob> start(Framebuffer &target, const RenderOptions &options = {},
                                          std::function<void()> on_done = {});

    /// Goes on with another scene: quick where it came about by Accel::update(). Waits for a render in progress. Throws
    /// std::bad_alloc, and then keeps the scene it had.
    void set_accel(std::shared_ptr<const Accel> accel);

    [[nodiscard]] unsigned threads() const;
    /// The hook for the host's threads, or an empty one.
    [[nodiscard]] const SubmitTask &submit() const;
    /// Valid until another is set.
    [[nodiscard]] const Accel &accel() const;
    /// The instruction set whose kernel traces.
    [[nodiscard]] Isa isa() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace glint
