// The part of OBJ reading that starts from a text in memory.
#pragma once

#include <string>

#include <glint/read.hpp>

#include "text/text_file.hpp"

namespace glint {

/// As read_obj(), from a text that was read already; `name` is what diagnostics call the file. May throw
/// std::bad_alloc.
[[nodiscard]] Result<MeshFile> read_obj_text(TextFile text, const std::string &name, const SceneLimits &limits);

} // namespace glint
