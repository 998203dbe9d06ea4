// What an eye stands in.
#pragma once

#include <glint/scene.hpp>

#include "kernel/kernel.hpp"

namespace glint {

/// The scene's transmissive surfaces that the eye is inside of, in the scene's order, the first being the outermost.
[[nodiscard]] Media media_around(const Scene &scene, const Point &eye);

} // namespace glint
