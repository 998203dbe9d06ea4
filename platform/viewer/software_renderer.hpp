// Tells drivers that draw on the processor from graphics processors.
#pragma once

#include <string_view>

namespace glint::viewer {

/// Whether the processor draws in place of a graphics processor, for which the sharp filter is too dear. `gl_renderer`
/// is GL_RENDERER, or a text that has it in it.
[[nodiscard]] bool is_software(std::string_view gl_renderer);

} // namespace glint::viewer
