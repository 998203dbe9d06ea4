// A context's state as values that can be compared, and a context whose state is nowhere what it is by default.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gles/gl.hpp"

namespace glint::test {

/// State by name ("GL_VIEWPORT", "attribute 2 stride").
using GlSnapshot = std::map<std::string, std::vector<GLint>>;

/// Everything that a presenter could disturb.
[[nodiscard]] GlSnapshot take_snapshot(const gles::Gl &gl);

/// Sets whatever take_snapshot() sees to something unusual: all tests on and failing, colours masked, odd viewports,
/// rows with gaps, foreign objects bound everywhere. The objects die with the context.
void make_unusual(const gles::Gl &gl, const gles::ProcLoader &load);

} // namespace glint::test
