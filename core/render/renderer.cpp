// Hands a picture's tiles to the workers and watches over them.
#include <glint/renderer.hpp>

#include <chrono>
#include <mutex>

#include "kernel/kernel.hpp"
#include "render/aligned_memory.hpp"
#include "render/kernel_frame.hpp"
#include "render/shading_tables.hpp"
#include "render/tiling.hpp"
#include "threads/worker_pool.hpp"

namespace glint {

double RenderControl::progress() const {
    const uint32_t count = tile_count_.load(std::memory_order_relaxed);
    return count == 0 ? 0.0 : static_cast<double>(tiles_done_.load(std::memory_order_relaxed)) / count;
}

void RenderControl::reset() {
    cancelled_.store(false);
    tiles_done_.store(0);
    tile_count_.store(0);
}

struct Renderer::Impl {
    Impl(std::shared_ptr<const Accel> accel_, const RendererOptions &options)
        : accel(std::move(accel_)),
          tables(accel->scene()),
          kernel(kernel_for(options.isa)),
          pool(options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency())),
          workers(pool.threads()) {}

    /// A worker's memory, on cache lines of its own: the ray counts are written all the time.
    struct alignas(128) Worker {
        KernelScratch scratch;
        AlignedMemory memory;
    };

    std::shared_ptr<const Accel> accel;
    ShadingTables tables;
    const Kernel &kernel;
    WorkerPool pool;
    std::vector<Worker> workers;
    std::mutex one_render;
};

Renderer::Renderer(std::shared_ptr<const Accel> accel, const RendererOptions &options)
    : impl_(std::make_unique<Impl>(std::move(accel), options)) {}
Renderer::~Renderer() = default;

void Renderer::set_accel(std::shared_ptr<const Accel> accel) {
    const std::lock_guard lock(impl_->one_render);
    const Scene &scene = accel->scene();
    if (!scene.is_edit_of(impl_->accel->scene())) impl_->tables = ShadingTables(scene);
    impl_->accel = std::move(accel);
}

unsigned Renderer::threads() const {
    return impl_->pool.threads();
}
const Accel &Renderer::accel() const {
    return *impl_->accel;
}
Isa Renderer::isa() const {
    return impl_->kernel.isa;
}

Result<RenderStatistics> Renderer::render(Framebuffer &target, const RenderOptions &options, RenderControl *control) {
    const std::lock_guard lock(impl_->one_render);
    const auto start = std::chrono::steady_clock::now();
    const KernelScene kernel_scene = impl_->tables.kernel_scene(*impl_->accel);
    Result<KernelFrame> asked =
        kernel_frame(impl_->accel->scene(), kernel_scene, options, target.width_px(), target.height_px());
    if (!asked) return std::move(asked).error();
    KernelFrame &frame = *asked;
    frame.rgba8 = target.rgba8();
    frame.radiance = target.radiance();

    const Tiling tiling(frame.width_px, frame.height_px);
    RenderControl uncontrolled;
    RenderControl &watch = control ? *control : uncontrolled;
    watch.tiles_done_.store(0, std::memory_order_relaxed);
    watch.tile_count_.store(tiling.count(), std::memory_order_relaxed);
    const size_t scratch_bytes = impl_->kernel.scratch_bytes(kernel_scene, frame);
    for (Impl::Worker &worker : impl_->workers) {
        worker.scratch.rays = {};
        worker.scratch.memory = worker.memory.at_least(scratch_bytes);
    }

    TileQueue queue(tiling.count(), impl_->pool.threads());
    impl_->pool.run([&](unsigned worker) {
        KernelScratch &scratch = impl_->workers[worker].scratch;
        for (TileQueue::Run run = queue.next(); run.begin < run.end; run = queue.next()) {
            uint32_t tile = run.begin;
            for (; tile < run.end && !watch.cancelled(); ++tile) {
                impl_->kernel.render_tile(kernel_scene, frame, tiling.tile(tile), scratch);
            }
            watch.tiles_done_.fetch_add(tile - run.begin, std::memory_order_relaxed);
            if (tile < run.end) return;
        }
    });
    if (watch.tiles_done_.load() < tiling.count()) return Error(ErrorCode::cancelled, "the render was cancelled");

    RenderStatistics statistics;
    for (const Impl::Worker &worker : impl_->workers) {
        statistics.primary_rays += worker.scratch.rays.primary;
        statistics.shadow_rays += worker.scratch.rays.shadow;
        statistics.secondary_rays += worker.scratch.rays.secondary;
    }
    statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

} // namespace glint
