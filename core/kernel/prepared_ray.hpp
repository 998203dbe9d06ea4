// A ray with everything that depends on the ray alone worked out once.
#pragma once

#include <cmath>

#include "math/box.hpp"
#include "math/vec.hpp"

namespace glint {

/// A ray is org + t * dir; dir need not have unit length but is not zero.
struct Ray {
    glm::vec3 org;
    glm::vec3 dir;
};

/// Rounding errors in one place. With eps = 2^-24 (half an ulp of 1) and M the largest coordinate of the scene seen
/// from the ray's origin, a corner's position relative to the origin is off by at most eps * M, a slab distance by 3
/// eps * M, its position across the ray (see intersect.hpp) by 6 eps * M. `slack` = 16 eps * M covers any sum of these
/// that occurs. It is what keeps the tree from disagreeing with brute force: a ray passes a splitting plane anywhere
/// within slack of it.
inline constexpr float slack_of_extent = 0x1p-20f;

/// A ray with its axes permuted so that z is its major one (Woop, Benthin & Wald 2013).
struct PermutedRay {
    glm::vec3 org;
    glm::vec3 dir;
    int kx, ky, kz;
    glm::vec3 permuted_org, permuted_dir;

    explicit PermutedRay(const Ray &ray) : org(ray.org), dir(ray.dir) {
        const float x = std::abs(dir.x), y = std::abs(dir.y), z = std::abs(dir.z);
        kz = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        permuted_org = {component(org, kx), component(org, ky), component(org, kz)};
        permuted_dir = {component(dir, kx), component(dir, ky), component(dir, kz)};
    }
};

struct PreparedRay : PermutedRay {
    // For walking the tree.
    glm::vec3 inverse_dir;     ///< finite: components too small to matter are made tiny instead of zero
    glm::vec3 parameter_slack; ///< slack as a difference of t, along each axis
    float slack;               ///< as a length in space

    float shear_x, shear_y; ///< the shear that turns the ray onto its major axis

    PreparedRay(const Ray &ray, const Box &scene_bounds) : PermutedRay(ray) {
        shear_x = permuted_dir.x / permuted_dir.z;
        shear_y = permuted_dir.y / permuted_dir.z;

        const float to_lo = max_abs(scene_bounds.lo - org), to_hi = max_abs(scene_bounds.hi - org);
        slack = slack_of_extent * (to_lo > to_hi ? to_lo : to_hi);
        // A component 10^15 times smaller than the major one moves the ray by far less than slack within the scene.
        const float tiny = 1e-15f * std::abs(permuted_dir.z);
        for (int axis = 0; axis < 3; ++axis) {
            const float d = std::abs(dir[axis]) < tiny ? std::copysign(tiny, dir[axis]) : dir[axis];
            inverse_dir[axis] = 1.0f / d;
            parameter_slack[axis] = slack * std::abs(inverse_dir[axis]);
        }
    }
};

} // namespace glint
