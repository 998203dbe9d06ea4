// A render that goes on while its caller does other things.
#include "render/render_job.hpp"

#include <exception>

#include "threads/wait_for_change.hpp"

namespace glint {

void RenderJob::State::begin(unsigned threads, const SubmitTask &submit, const std::shared_ptr<State> &self) {
    if (!own_pool) return submit_tasks(submit, threads, [self] { self->help(); });
    try {
        leader = std::thread([self] { self->help(); });
    } catch (const std::exception &) {
        // No thread is to be had: whoever waits for the job is the first to help.
    }
}

void RenderJob::State::help() {
    work.enter(); // first of all, so that the work is not over before the pool is free again
    if (own_pool && !is_led.exchange(true)) {
        own_pool->run([this](unsigned) { work.take_part(); });
    } else {
        work.take_part();
    }
    if (!work.leave()) return;
    outcome = tracing.outcome();
    stage.store(telling_stage);
    stage.notify_all();
    try {
        if (on_done) on_done();
    } catch (...) {
        // It was asked to throw nothing, and there is nobody to tell.
    }
    stage.store(over_stage);
    stage.notify_all();
}

void RenderJob::State::wait_for_picture() const {
    wait_for_change(stage, tracing_stage);
}

void RenderJob::State::wait_for_end() const {
    wait_for_change(stage, tracing_stage);
    wait_for_change(stage, telling_stage);
}

RenderJob::RenderJob(std::shared_ptr<State> state) : state_(std::move(state)) {}
RenderJob::RenderJob(RenderJob &&other) noexcept = default;

RenderJob &RenderJob::operator=(RenderJob &&other) noexcept {
    if (this != &other) {
        stop();
        state_ = std::move(other.state_);
    }
    return *this;
}

RenderJob::~RenderJob() {
    stop();
}

void RenderJob::stop() {
    if (!state_) return;
    state_->control.cancel();
    state_->help();
    state_->wait_for_end();
    if (state_->leader.joinable()) state_->leader.join();
}

double RenderJob::progress() const {
    return state_->control.progress();
}

void RenderJob::cancel() {
    state_->control.cancel();
}

bool RenderJob::is_done() const {
    return state_->is_done();
}

Result<RenderStatistics> RenderJob::wait() {
    if (!state_->is_done()) state_->help();
    state_->wait_for_end();
    return state_->outcome.result();
}

} // namespace glint
