// The door from the packet kernels to the definition of a hit: compiled once, for every machine alike.
#pragma once

namespace glint {

/// exact_distance() of intersect.hpp for one ray and one triangle given by plain numbers: three each for origin and
/// direction, nine for the corners. Packet kernels ask here where their own filter cannot tell.
[[nodiscard]] float exact_distance(const float *org, const float *dir, const float *corners);

} // namespace glint
