// Compiling and linking the presenter's shaders.
#pragma once

#include <glint/result.hpp>

#include "gles/gl.hpp"

namespace glint::gles {

/// Links a program from two shaders; its attribute `attribute_name` is number 0. The caller owns the program's name.
/// Fails with the driver's log.
[[nodiscard]] Result<GLuint> link_program(const Gl &gl, const char *vertex_source, const char *fragment_source,
                                          const char *attribute_name);

} // namespace glint::gles
