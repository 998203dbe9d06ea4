// One picture being traced, by whoever takes part.
#include "render/tracing.hpp"

namespace glint {

Result<RenderStatistics> TracingOutcome::result() const {
    if (!failure) return statistics;
    if (*failure == ErrorCode::out_of_memory) return Error::out_of_memory();
    return Error(*failure, "the render was cancelled");
}

Tracing::Tracing(const Kernel &kernel, const KernelScene &scene, const KernelFrame &frame,
                 std::vector<TracingWorker> &workers, RenderControl &control)
    : kernel_(kernel),
      scene_(scene),
      frame_(frame),
      workers_(workers),
      control_(control),
      tiling_(frame.width_px, frame.height_px),
      queue_(tiling_.count(), static_cast<unsigned>(workers.size())) {
    control_.tiles_done_.store(0, std::memory_order_relaxed);
    control_.tile_count_.store(tiling_.count(), std::memory_order_relaxed);
    const size_t scratch_bytes = kernel_.scratch_bytes(scene_, frame_);
    for (TracingWorker &worker : workers_) {
        worker.scratch.rays = {};
        worker.scratch.memory = worker.memory.at_least(scratch_bytes);
    }
}

void Tracing::work(unsigned worker) noexcept {
    KernelScratch &scratch = workers_[worker].scratch;
    for (TileQueue::Run run = queue_.next(); run.begin < run.end; run = queue_.next()) {
        uint32_t tile = run.begin;
        try {
            for (; tile < run.end && !control_.cancelled(); ++tile) {
                kernel_.render_tile(scene_, frame_, tiling_.tile(tile), scratch);
            }
        } catch (const std::bad_alloc &) {
            is_out_of_memory_.store(true, std::memory_order_relaxed);
            queue_.close();
        }
        control_.tiles_done_.fetch_add(tile - run.begin, std::memory_order_relaxed);
        if (tile < run.end) return;
    }
}

TracingOutcome Tracing::outcome() const {
    TracingOutcome outcome;
    if (is_out_of_memory_.load()) {
        outcome.failure = ErrorCode::out_of_memory;
    } else if (control_.tiles_done_.load() < tiling_.count()) {
        outcome.failure = ErrorCode::cancelled;
    }
    RenderStatistics &sum = outcome.statistics;
    for (const TracingWorker &worker : workers_) {
        sum.primary_rays += worker.scratch.rays.primary;
        sum.shadow_rays += worker.scratch.rays.shadow;
        sum.secondary_rays += worker.scratch.rays.secondary;
    }
    sum.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return outcome;
}

} // namespace glint
