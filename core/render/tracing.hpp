// One picture being traced, by whoever takes part.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <glint/renderer.hpp>

#include "kernel/kernel.hpp"
#include "render/aligned_memory.hpp"
#include "render/tiling.hpp"

namespace glint {

/// A worker's memory, on cache lines of its own: the ray counts are written all the time.
struct alignas(128) TracingWorker {
    KernelScratch scratch;
    AlignedMemory memory;
};

/// How a picture ended, told without asking for memory.
struct TracingOutcome {
    std::optional<ErrorCode> failure; ///< cancelled or out_of_memory
    RenderStatistics statistics;

    [[nodiscard]] Result<RenderStatistics> result() const;
};

/// Everything it is given must outlive it, or the last call of work() at least; the scene and the frame are copied.
class Tracing {
public:
    /// Prepares the workers' memory. Throws std::bad_alloc.
    Tracing(const Kernel &kernel, const KernelScene &scene, const KernelFrame &frame,
            std::vector<TracingWorker> &workers, RenderControl &control);

    /// Traces tiles until none is left to begin: none at all, or none that is wanted. `worker` is of no other thread.
    void work(unsigned worker) noexcept;

    /// Once all calls of work() have returned, and until the workers' memory is used for another picture.
    [[nodiscard]] TracingOutcome outcome() const;

private:
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const Kernel &kernel_;
    const KernelScene scene_;
    const KernelFrame frame_;
    std::vector<TracingWorker> &workers_;
    RenderControl &control_;
    const Tiling tiling_;
    TileQueue queue_;
    std::atomic<bool> is_out_of_memory_{false};
};

} // namespace glint
