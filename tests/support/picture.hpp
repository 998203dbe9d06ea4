// Rendering in one line, for tests.
#pragma once

#include <stdexcept>

#include <glint/glint.hpp>

namespace glint::test {

/// Renders with the given depth; throws what went wrong.
inline Framebuffer render(const std::shared_ptr<const Accel> &accel, uint32_t width, uint32_t height, uint32_t depth,
                          const RendererOptions &renderer_options) {
    auto target = Framebuffer::create(width, height);
    if (!target) throw std::runtime_error(target.error().text());
    RenderOptions options;
    options.max_depth = depth;
    const auto done = Renderer(accel, renderer_options).render(*target, options);
    if (!done) throw std::runtime_error(done.error().text());
    return std::move(target).value();
}

/// The same, of a scene that is rendered once, with the best instruction set.
inline Framebuffer render(const std::shared_ptr<const Scene> &scene, uint32_t width, uint32_t height, uint32_t depth,
                          unsigned threads = 2, AccelKind kind = AccelKind::automatic) {
    return render(Accel::build(scene, {kind, 1}), width, height, depth, {.threads = threads});
}

/// The linear colour of a pixel.
inline Color pixel(const Framebuffer &picture, uint32_t x, uint32_t y) {
    const float *p = picture.radiance() + (size_t{y} * picture.width_px() + x) * 3;
    return {p[0], p[1], p[2]};
}

} // namespace glint::test
