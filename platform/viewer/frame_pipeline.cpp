// Traces frame n + 1 while frame n is being shown.
#include "viewer/frame_pipeline.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace glint::viewer {

FramePipeline::FramePipeline() : tracer_([this] { live(); }) {}

FramePipeline::~FramePipeline() {
    {
        const std::lock_guard lock(mutex_);
        stops_ = true;
        control_.cancel();
    }
    for_tracer_.notify_one();
    tracer_.join();
}

void FramePipeline::submit(FrameRequest request) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(request);
        if (refines_) {
            control_.cancel();
            if (is_tracing_) stopped_ = Clock::now();
        }
        refines_ = false;
    }
    for_tracer_.notify_one();
}

void FramePipeline::stop_refining() {
    const std::lock_guard lock(mutex_);
    refines_ = false;
}

bool FramePipeline::is_idle() const {
    const std::lock_guard lock(mutex_);
    return !waiting_ && !refines_ && !is_tracing_ && !has_finished_;
}

Result<const Frame *> FramePipeline::take(Clock::time_point deadline) {
    std::unique_lock lock(mutex_);
    for_shower_.wait_until(lock, deadline, [&] { return has_finished_ || failure_; });
    if (failure_) return *std::exchange(failure_, std::nullopt);
    if (!has_finished_) return nullptr;
    has_finished_ = false;
    std::swap(finished_, shown_);
    lock.unlock();
    for_tracer_.notify_one();
    return shown_;
}

void FramePipeline::live() {
    while (true) {
        bool is_next_pass = false;
        {
            std::unique_lock lock(mutex_);
            // Of a picture that gets better, every pass is shown.
            for_tracer_.wait(lock, [&] { return waiting_ || (refines_ && !has_finished_) || stops_; });
            if (stops_) return;
            is_next_pass = !waiting_;
            if (is_next_pass) {
                request_.input_time.reset(); // the first pass answered it
            } else {
                request_ = std::move(*std::exchange(waiting_, std::nullopt));
                refines_ = request_.refines;
            }
            traced_->stop_s.reset();
            if (stopped_) {
                traced_->stop_s = std::chrono::duration<double>(Clock::now() - *stopped_).count();
                stopped_.reset();
            }
            control_.reset();
            is_tracing_ = true;
        }

        // A thread has nobody to throw to.
        Status traced = Done{};
        try {
            traced = trace(is_next_pass);
        } catch (const std::bad_alloc &) {
            traced = Error(ErrorCode::limit_exceeded, "out of memory for a picture");
        } catch (const std::exception &error) {
            traced = Error(ErrorCode::unsupported, error.what());
        }

        {
            const std::lock_guard lock(mutex_);
            is_tracing_ = false;
            if (traced) {
                traced_->finished = Clock::now();
                if (traced_->is_final) refines_ = false;
                std::swap(traced_, finished_);
                has_finished_ = true;
            } else if (traced.error().code != ErrorCode::cancelled) {
                refines_ = false;
                failure_ = traced.error();
            }
        }
        for_shower_.notify_one();
    }
}

Status FramePipeline::trace(bool is_next_pass) {
    const FrameRequest &request = request_;
    if (!renderer_ || renderer_threads_ != request.threads || renderer_->isa() != request.isa) {
        renderer_ =
            std::make_unique<Renderer>(request.accel, RendererOptions{.threads = request.threads, .isa = request.isa});
        renderer_threads_ = request.threads;
    } else if (&renderer_->accel() != request.accel.get()) {
        renderer_->set_accel(request.accel);
    }
    Frame &frame = *traced_;
    if (!frame.picture || frame.picture->width_px() != request.width_px ||
        frame.picture->height_px() != request.height_px) {
        Result<Framebuffer> picture = Framebuffer::create(request.width_px, request.height_px, false);
        if (!picture) return picture.error();
        frame.picture = std::move(*picture);
    }
    if (request.refines && !is_next_pass) refiner_.restart(request.how);
    const Result<RenderStatistics> statistics = request.refines ? refiner_.next(*renderer_, *frame.picture, &control_)
                                                                : renderer_->render(*frame.picture, request.how);
    if (!statistics) return statistics.error();
    frame.request = request;
    frame.statistics = *statistics;
    frame.samples = request.refines ? std::max(refiner_.samples_done(), 1u) : request.how.samples_per_pixel.value_or(1);
    frame.is_final = !request.refines || refiner_.done();
    frame.number = ++number_;
    return Done{};
}

} // namespace glint::viewer
