// Framebuffers for C.
#include "c/render_handles.hpp"
#include "c/sized.hpp"

using namespace glint;

glint_error glint_framebuffer::take(Result<Framebuffer> made) {
    if (!made) return fail(made.error());
    picture = std::make_shared<Framebuffer>(std::move(made).value());
    return GLINT_OK;
}

glint_error glint_framebuffer_create(uint32_t width_px, uint32_t height_px, int32_t with_radiance,
                                     glint_framebuffer **framebuffer) {
    return create(framebuffer, [&](glint_framebuffer &handle) -> glint_error {
        return handle.take(Framebuffer::create(width_px, height_px, with_radiance != 0));
    });
}

glint_error glint_framebuffer_wrap(uint32_t width_px, uint32_t height_px, uint8_t *rgba8, size_t stride_bytes,
                                   float *radiance, size_t radiance_stride_bytes, glint_framebuffer **framebuffer) {
    return create(framebuffer, [&](glint_framebuffer &handle) -> glint_error {
        const size_t stride = stride_bytes > 0 ? stride_bytes : size_t{4} * width_px;
        return handle.take(Framebuffer::wrap(width_px, height_px, rgba8, stride, radiance, radiance_stride_bytes));
    });
}

void glint_framebuffer_release(glint_framebuffer *framebuffer) {
    release(framebuffer);
}

glint_error glint_framebuffer_get_pixels(const glint_framebuffer *framebuffer, glint_pixels *pixels) {
    if (!is_made(framebuffer)) return GLINT_ERROR_INVALID_ARGUMENT;
    Framebuffer &from = *framebuffer->picture;
    return give(pixels, glint_pixels{sizeof(glint_pixels), from.rgba8(), from.radiance(), from.rgba8_stride_bytes(),
                                     from.radiance_stride_bytes(), from.width_px(), from.height_px()});
}

uint64_t glint_framebuffer_pixel_hash(const glint_framebuffer *framebuffer) {
    return is_made(framebuffer) ? framebuffer->picture->pixel_hash() : 0;
}
