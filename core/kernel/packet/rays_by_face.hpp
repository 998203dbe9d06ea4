// Rays that go all ways, in parts that go one way each.
#pragma once

#include "kernel/packet/ray_group.hpp"

namespace glint::HWY_NAMESPACE {

/// The selected rays by where they mostly go: those of one part are at most 45 degrees off one axis.
struct RaysByFace {
    RaySelection face[6]; ///< of a cube around the origin: -x, -y, -z, x, y, z

    HWY_INLINE RaysByFace(const RayGroup &rays, const RaySelection &selection) : face{} {
        for_each_vector(selection, [&](uint32_t ray, uint32_t lanes) {
            const Points dir = rays.dir(ray);
            const Floats x = hn::Abs(dir.x), y = hn::Abs(dir.y), z = hn::Abs(dir.z);
            const uint32_t by_x = bits_of(hn::And(hn::Ge(x, y), hn::Ge(x, z))) & lanes;
            const uint32_t by_y = bits_of(hn::Ge(y, z)) & lanes & ~by_x;
            const auto put = [&](int axis, uint32_t bits, Floats along) {
                const uint32_t upward = bits_of(hn::Gt(along, hn::Zero(floats))) & bits;
                face[axis].add(ray, bits & ~upward);
                face[axis + 3].add(ray, upward);
            };
            put(0, by_x, dir.x);
            put(1, by_y, dir.y);
            put(2, lanes & ~by_x & ~by_y, dir.z);
        });
    }
};

} // namespace glint::HWY_NAMESPACE
