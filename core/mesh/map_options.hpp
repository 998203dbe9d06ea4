// The options that may stand before the name of a texture's file in an MTL file.
#pragma once

#include "mesh/obj_lines.hpp"
#include "text/problems.hpp"

namespace glint {

/// Walks over the options of `map_Kd` from `at` on, in the current line, and returns where the name of the file begins,
/// or nullptr after an error. None of the options has an effect here: those that would change the picture are warned
/// of, each at its place.
[[nodiscard]] char *check_map_options(char *at, const ObjLines &lines, Problems &problems);

} // namespace glint
