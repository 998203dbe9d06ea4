// How far the rays of each block can get along every axis: they go all ways, but neighbours often go the same way along
// some axes, and so never come to what lies behind them.
#pragma once

#include "kernel/packet/ray_group.hpp"

namespace glint::HWY_NAMESPACE {

class BlockReach {
public:
    /// `slack` is added everywhere. Blocks without rays reach nothing.
    HWY_INLINE BlockReach(const RayGroup &rays, const RaySelection &selection, float slack) {
        const float everywhere = __builtin_inff();
        for (uint32_t block = 0; block < block_count; ++block) {
            for (int axis = 0; axis < 3; ++axis) {
                Floats lo = splat(everywhere), hi = splat(-everywhere);
                uint32_t falls = 0, rises = 0;
                for (uint32_t part = 0; part < block_size; part += lane_count) {
                    const uint32_t ray = block * block_size + part, lanes = selection.lanes(ray);
                    const Floats org = hn::Load(floats, rays.org_row(axis) + ray);
                    lo = hn::Min(lo, hn::IfThenElse(mask_of(lanes), org, lo));
                    hi = hn::Max(hi, hn::IfThenElse(mask_of(lanes), org, hi));
                    const uint32_t negative =
                        bits_of(hn::Lt(hn::Load(floats, rays.dir_row(axis) + ray), hn::Zero(floats)));
                    falls |= negative & lanes;
                    rises |= ~negative & lanes;
                }
                lo_[axis][block] = falls != 0 ? -everywhere : least_lane(lo) - slack;
                hi_[axis][block] = rises != 0 ? everywhere : greatest_lane(hi) + slack;
            }
        }
    }

    /// Bit b for every block that a triangle with these corners is not out of reach of.
    [[nodiscard]] HWY_INLINE uint32_t of(const float (&corners)[9]) const {
        uint32_t reached = 0;
        for (uint32_t b = 0; b < block_count; b += lane_count) {
            FloatMask in_reach = hn::Le(hn::Zero(floats), hn::Zero(floats));
            for (int axis = 0; axis < 3; ++axis) {
                const float x = corners[axis], y = corners[3 + axis], z = corners[6 + axis];
                in_reach = hn::And(in_reach, hn::Ge(splat(larger(larger(x, y), z)), hn::Load(floats, lo_[axis] + b)));
                in_reach = hn::And(in_reach, hn::Le(splat(smaller(smaller(x, y), z)), hn::Load(floats, hi_[axis] + b)));
            }
            reached |= bits_of(in_reach) << b;
        }
        return reached;
    }

private:
    alignas(64) float lo_[3][block_count], hi_[3][block_count];
};

} // namespace glint::HWY_NAMESPACE
