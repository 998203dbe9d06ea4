// The picture of a camera at rest, for C.
#include <glint/view.h>

#include <optional>

#include <glint/refiner.hpp>

#include "c/render_handles.hpp"

struct glint_refiner : glint::HandleOf<glint::HandleKind::refiner> {
    [[nodiscard]] bool is_made() const { return refiner.has_value(); }

    std::optional<glint::Refiner> refiner;
    glint::RenderControl control;
};

using namespace glint;

glint_error glint_refiner_create(const glint_render_options *options, glint_refiner **refiner) {
    return create(refiner, [&](glint_refiner &handle) -> glint_error {
        RenderOptions converted;
        if (const char *const problem = convert(options, converted)) return handle.refuse(problem);
        handle.refiner.emplace(converted);
        return GLINT_OK;
    });
}

void glint_refiner_release(glint_refiner *refiner) {
    release(refiner);
}

glint_error glint_refiner_restart(glint_refiner *refiner, const glint_render_options *options) {
    return call(refiner, [&](glint_refiner &handle) -> glint_error {
        RenderOptions converted;
        if (const char *const problem = convert(options, converted)) return handle.refuse(problem);
        handle.refiner->restart(converted);
        return GLINT_OK;
    });
}

glint_error glint_refiner_next(glint_refiner *refiner, glint_renderer *renderer, glint_framebuffer *framebuffer,
                               glint_render_statistics *statistics) {
    return call(refiner, [&](glint_refiner &handle) -> glint_error {
        if (const char *const problem = problem_of(renderer, framebuffer, statistics)) return handle.refuse(problem);
        const Result<RenderStatistics> result =
            handle.refiner->next(*renderer->renderer, *framebuffer->picture, &handle.control);
        handle.control.reset();
        return report(handle, result, statistics);
    });
}

void glint_refiner_cancel(glint_refiner *refiner) {
    if (is_made(refiner)) refiner->control.cancel();
}

int32_t glint_refiner_is_done(const glint_refiner *refiner) {
    return is_made(refiner) && refiner->refiner->done();
}

uint32_t glint_refiner_samples_done(const glint_refiner *refiner) {
    return is_made(refiner) ? refiner->refiner->samples_done() : 0;
}
