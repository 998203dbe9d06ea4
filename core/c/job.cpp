// Renders that go on while their caller does other things, for C.
#include "c/render_handles.hpp"
#include "c/sized.hpp"

struct glint_job : glint::HandleOf<glint::HandleKind::job> {
    [[nodiscard]] bool is_made() const { return job.has_value(); }

    // What the job needs, however early their handles are released; it goes first.
    std::shared_ptr<glint::Framebuffer> picture;
    std::shared_ptr<glint::Renderer> renderer;
    std::optional<glint::RenderJob> job;
};

using namespace glint;

glint_error glint_renderer_start(glint_renderer *renderer, glint_framebuffer *framebuffer,
                                 const glint_render_options *options, glint_done_function on_done, void *user,
                                 glint_job **job) {
    return create(job, [&](glint_job &handle) -> glint_error {
        if (const char *const problem = problem_of(renderer, framebuffer, nullptr)) return handle.refuse(problem);
        RenderOptions converted;
        if (const char *const problem = convert(options, converted)) return handle.refuse(problem);
        handle.picture = framebuffer->picture;
        handle.renderer = renderer->renderer;
        std::function<void()> done;
        if (on_done) done = [on_done, user] { on_done(user); };
        Result<RenderJob> started = handle.renderer->start(*handle.picture, converted, std::move(done));
        if (!started) return handle.fail(started.error());
        handle.job = std::move(started).value();
        return GLINT_OK;
    });
}

double glint_job_progress(const glint_job *job) {
    return is_made(job) ? job->job->progress() : 0.0;
}

int32_t glint_job_is_done(const glint_job *job) {
    return is_made(job) && job->job->is_done();
}

void glint_job_cancel(glint_job *job) {
    if (is_made(job)) job->job->cancel();
}

glint_error glint_job_wait(glint_job *job, glint_render_statistics *statistics) {
    return call(job, [&](glint_job &handle) -> glint_error {
        if (statistics && !is_sized(statistics)) return handle.refuse("the statistics are not a valid struct");
        return report(handle, handle.job->wait(), statistics);
    });
}

void glint_job_release(glint_job *job) {
    release(job);
}
