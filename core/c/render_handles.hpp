// The handles of framebuffers and renderers, and what the other parts of the C interface need of them.
#pragma once

#include <memory>
#include <optional>

#include <glint/accel.hpp>
#include <glint/framebuffer.hpp>
#include <glint/renderer.h>
#include <glint/renderer.hpp>

#include "c/handle.hpp"

// What jobs need of either lives on after the handle.
struct glint_framebuffer : glint::HandleOf<glint::HandleKind::framebuffer> {
    [[nodiscard]] bool is_made() const { return picture != nullptr; }
    glint_error take(glint::Result<glint::Framebuffer> made);

    std::shared_ptr<glint::Framebuffer> picture;
};

struct glint_renderer : glint::HandleOf<glint::HandleKind::renderer> {
    [[nodiscard]] bool is_made() const { return renderer != nullptr; }

    glint::AccelOptions accel_options;
    std::shared_ptr<const glint::Accel> accel;
    std::shared_ptr<glint::Renderer> renderer;
};

namespace glint {

/// The options in C++; what is wrong with them, or nullptr.
[[nodiscard]] const char *convert(const glint_render_options *given, RenderOptions &options);

/// What keeps a picture from being rendered, or nullptr.
[[nodiscard]] const char *problem_of(const glint_renderer *renderer, const glint_framebuffer *framebuffer,
                                     const glint_render_statistics *place);
/// Fills the place, where there is one; or says what went wrong.
glint_error report(Handle &handle, const Result<RenderStatistics> &result, glint_render_statistics *place);

} // namespace glint
