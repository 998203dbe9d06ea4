// Kernels against each other on the same rays, bit by bit.
#pragma once

#include <memory>
#include <string>

#include <glint/scene.hpp>

namespace glint::test {

struct RayComparison {
    uint64_t rays = 0; ///< different ones; each was traced six times or more by every kernel
    uint64_t hits = 0; ///< of them, within their limits
    uint64_t differences = 0;
    std::string first_difference;

    RayComparison &operator+=(const RayComparison &other);
};

/// Traces batches first <= number < last of the scene's first mesh with the kernels of all available instruction sets,
/// through the kd-tree, through the bounding volume hierarchy and, batches whose number `brute_force_every` divides, by
/// brute force; compares with the scalar kernel's walk through the kd-tree: closest hits and any hits, once up to the
/// batches' own limits, once up to each closest hit and the floats next to it.
[[nodiscard]] RayComparison compare_rays(const std::shared_ptr<const Scene> &scene, uint32_t first, uint32_t last,
                                         uint32_t brute_force_every = 1);

} // namespace glint::test
