// Hands a picture's tiles to the workers and watches over them.
#include <glint/renderer.hpp>

#include <mutex>
#include <new>

#include "render/kernel_frame.hpp"
#include "render/render_job.hpp"
#include "render/shading_tables.hpp"
#include "render/tracing.hpp"
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

namespace {

/// What is to be traced.
struct Picture {
    KernelScene scene;
    KernelFrame frame;
};

} // namespace

struct Renderer::Impl {
    Impl(std::shared_ptr<const Accel> accel_, const RendererOptions &options)
        : accel(std::move(accel_)),
          tables(accel->scene()),
          kernel(kernel_for(options.isa)),
          submit(options.submit),
          pool(Crew(options.threads, submit)),
          workers(pool.threads()) {}

    /// Has the renderer to oneself as long as one holds the lock. A job that was started is over then: one helps it,
    /// since nobody else might.
    [[nodiscard]] std::unique_lock<std::mutex> take_turn() {
        while (true) {
            std::unique_lock lock(one_render);
            const std::shared_ptr<RenderJob::State> job = started.lock();
            if (!job || job->is_done()) return lock;
            lock.unlock();
            job->help();
            job->wait_for_picture();
        }
    }

    [[nodiscard]] Result<Picture> picture(Framebuffer &target, const RenderOptions &options) const {
        const KernelScene scene = tables.kernel_scene(*accel);
        Result<KernelFrame> frame = kernel_frame(accel->scene(), scene, options, target.width_px(), target.height_px());
        if (!frame) return std::move(frame).error();
        frame->rgba8 = target.rgba8();
        frame->rgba8_stride_bytes = target.rgba8_stride_bytes();
        frame->radiance = target.radiance();
        frame->radiance_stride_bytes = target.radiance_stride_bytes();
        return Picture{scene, *frame};
    }

    std::shared_ptr<const Accel> accel;
    ShadingTables tables;
    const Kernel &kernel;
    const SubmitTask submit;
    WorkerPool pool;
    std::vector<TracingWorker> workers;
    std::mutex one_render;
    std::weak_ptr<RenderJob::State> started;
};

Renderer::Renderer(std::shared_ptr<const Accel> accel, const RendererOptions &options)
    : impl_(std::make_unique<Impl>(std::move(accel), options)) {}
Renderer::~Renderer() = default;

void Renderer::set_accel(std::shared_ptr<const Accel> accel) {
    const auto turn = impl_->take_turn();
    const Scene &scene = accel->scene();
    if (!scene.is_edit_of(impl_->accel->scene())) impl_->tables = ShadingTables(scene);
    impl_->accel = std::move(accel);
}

unsigned Renderer::threads() const {
    return impl_->pool.threads();
}
const SubmitTask &Renderer::submit() const {
    return impl_->submit;
}
const Accel &Renderer::accel() const {
    return *impl_->accel;
}
Isa Renderer::isa() const {
    return impl_->kernel.isa;
}

Result<RenderStatistics> Renderer::render(Framebuffer &target, const RenderOptions &options,
                                          RenderControl *control) try {
    const auto turn = impl_->take_turn();
    Result<Picture> picture = impl_->picture(target, options);
    if (!picture) return std::move(picture).error();
    RenderControl uncontrolled;
    Tracing tracing(impl_->kernel, picture->scene, picture->frame, impl_->workers, control ? *control : uncontrolled);
    impl_->pool.run([&](unsigned worker) { tracing.work(worker); });
    return tracing.outcome().result();
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

Result<RenderJob> Renderer::start(Framebuffer &target, const RenderOptions &options,
                                  std::function<void()> on_done) try {
    auto turn = impl_->take_turn();
    Result<Picture> picture = impl_->picture(target, options);
    if (!picture) return std::move(picture).error();
    auto job = std::make_shared<RenderJob::State>(impl_->kernel, picture->scene, picture->frame, impl_->workers,
                                                  impl_->pool, std::move(on_done));
    impl_->started = job;
    turn.unlock();
    job->begin(impl_->pool.threads(), impl_->submit, job);
    return RenderJob(std::move(job));
} catch (const std::bad_alloc &) {
    return Error::out_of_memory();
}

} // namespace glint
