// OpenGL functions in place of the context's own, to see what a presenter does with contexts this machine has not.
#pragma once

#include <map>
#include <string>

#include <glint/gles/surface.hpp>

#include "gles/gl.hpp"

namespace glint::test {

/// A function, or nullptr for one that is not there, by the name it takes the place of.
using Substitutes = std::map<std::string, void *>;

template <typename Result, typename... Arguments> [[nodiscard]] void *as_proc(Result (*function)(Arguments...)) {
    return reinterpret_cast<void *>(function);
}

/// Loads what `load` loads, but for the substitutes.
[[nodiscard]] gles::ProcLoader with_substitutes(gles::ProcLoader load, Substitutes substitutes);

/// The context as one that says it is OpenGL ES 2.0 without any extension, and has no newer function.
[[nodiscard]] gles::ProcLoader as_es2(const gles::ProcLoader &load);

} // namespace glint::test
