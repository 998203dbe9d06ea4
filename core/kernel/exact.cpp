// The definition of a hit, for packet kernels.
#include "kernel/exact.hpp"

#include "kernel/intersect.hpp"

namespace glint {

float exact_distance(const float *org, const float *dir, const float *corners) {
    const PermutedRay ray({{org[0], org[1], org[2]}, {dir[0], dir[1], dir[2]}});
    return exact_distance(ray, {{corners[0], corners[1], corners[2]},
                                {corners[3], corners[4], corners[5]},
                                {corners[6], corners[7], corners[8]}});
}

} // namespace glint
