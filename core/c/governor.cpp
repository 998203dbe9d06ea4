// The governor of the frame rate, for C.
#include <glint/view.h>

#include <optional>

#include <glint/governor.hpp>

#include "c/handle.hpp"
#include "c/sized.hpp"

struct glint_governor : glint::HandleOf<glint::HandleKind::governor> {
    [[nodiscard]] bool is_made() const { return governor.has_value(); }

    std::optional<glint::Governor> governor;
};

using namespace glint;

namespace {

glint_governor_options default_options() {
    const GovernorOptions from;
    return {
        sizeof(glint_governor_options), from.target_fps, from.least_scale, from.least_depth, from.greatest_depth, 0};
}

} // namespace

glint_error glint_governor_options_init(glint_governor_options *options, size_t size) {
    return init(options, size, default_options());
}

glint_error glint_governor_create(const glint_governor_options *options, glint_governor **governor) {
    return create(governor, [&](glint_governor &handle) -> glint_error {
        glint_governor_options given = default_options();
        if (!take(options, given)) return handle.refuse("the options are not a valid struct: see their size");
        Result<Governor> made =
            Governor::create({given.target_fps, given.least_scale, given.least_depth, given.greatest_depth});
        if (!made) return handle.fail(made.error());
        handle.governor = std::move(made).value();
        return GLINT_OK;
    });
}

void glint_governor_release(glint_governor *governor) {
    release(governor);
}

glint_error glint_governor_get_quality(const glint_governor *governor, glint_frame_quality *quality) {
    if (!is_made(governor) || !quality) return GLINT_ERROR_INVALID_ARGUMENT;
    const FrameQuality now = governor->governor->quality();
    *quality = {now.scale, now.depth};
    return GLINT_OK;
}

glint_error glint_governor_measured(glint_governor *governor, const glint_frame_quality *quality,
                                    const glint_frame_times *times) {
    return call(governor, [&](glint_governor &handle) -> glint_error {
        if (!quality || !times) return handle.refuse("the quality or the times are NULL");
        handle.governor->measured({quality->scale, quality->depth},
                                  {times->render_s, times->present_s, times->frame_s, times->wait_s});
        return GLINT_OK;
    });
}

glint_error glint_governor_set_greatest_depth(glint_governor *governor, uint32_t depth) {
    return call(governor, [&](glint_governor &handle) -> glint_error {
        handle.governor->set_greatest_depth(depth);
        return GLINT_OK;
    });
}

glint_error glint_scaled_size(uint32_t width_px, uint32_t height_px, float scale, uint32_t *scaled_width_px,
                              uint32_t *scaled_height_px) {
    if (width_px == 0 || height_px == 0 || !(scale > 0.0f && scale <= 1.0f) || !scaled_width_px || !scaled_height_px) {
        return GLINT_ERROR_INVALID_ARGUMENT;
    }
    const PictureSize size = scaled_size(width_px, height_px, scale);
    *scaled_width_px = size.width_px;
    *scaled_height_px = size.height_px;
    return GLINT_OK;
}
