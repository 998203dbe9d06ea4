// What stands behind the public RenderJob: a picture that several threads may help with, or none.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>

#include <glint/render_job.hpp>

#include "render/tracing.hpp"
#include "threads/shared_work.hpp"
#include "threads/worker_pool.hpp"

namespace glint {

/// Shared by the job, the renderer and the tasks handed out, of which some may come when all else is gone: then they
/// find the work closed, and touch nothing else.
struct RenderJob::State {
    State(const Kernel &kernel, const KernelScene &scene, const KernelFrame &frame, std::vector<TracingWorker> &workers,
          WorkerPool &pool, std::function<void()> on_done_)
        : tracing(kernel, scene, frame, workers, control),
          work([this](unsigned worker) { tracing.work(worker); }, static_cast<unsigned>(workers.size())),
          on_done(std::move(on_done_)),
          own_pool(pool.is_own() ? &pool : nullptr) {}

    /// Has the pool's threads, or the host's, come and help. `self` is this.
    void begin(unsigned threads, const SubmitTask &submit, const std::shared_ptr<State> &self);

    /// Traces what nobody has begun. Whoever finds the picture done tells the rest.
    void help();

    [[nodiscard]] bool is_done() const { return stage.load() != tracing_stage; }
    /// Waits until the picture is done, or given up. Somebody must have helped.
    void wait_for_picture() const;
    /// And until on_done has returned.
    void wait_for_end() const;

    enum Stage : uint32_t { tracing_stage, telling_stage, over_stage };

    RenderControl control;
    Tracing tracing;
    SharedWork work;
    std::function<void()> on_done;
    TracingOutcome outcome; ///< valid once is_done()
    std::atomic<uint32_t> stage{tracing_stage};
    /// Of the library's own threads: the pool, which one of those who help leads. nullptr on the host's.
    WorkerPool *const own_pool;
    std::atomic<bool> is_led{false};
    std::thread leader; ///< where the system gave one
};

} // namespace glint
