// Where a scene's things are.
#pragma once

#include <glint/scene.hpp>

#include "math/box.hpp"

namespace glint {

/// Holds all objects' triangles and ellipsoids. Not what goes on for ever, nor lamps, which may stand far off; empty
/// where nothing is left.
[[nodiscard]] Box bounds_of_objects(const Scene &scene);

} // namespace glint
