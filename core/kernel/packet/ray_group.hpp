// Up to 256 rays that are traced together, coordinate by coordinate.
#pragma once

#include "kernel/packet/lanes.hpp"

namespace glint::HWY_NAMESPACE {

/// A block is what is culled as one: 4 x 4 pixels of a tile. A group is a tile's worth of blocks.
inline constexpr uint32_t block_size = 16, block_count = 16, group_size = block_size * block_count;

/// Which rays of a group are meant: bit r of block b for ray 16 b + r.
struct RaySelection {
    uint16_t blocks[block_count];

    [[nodiscard]] HWY_INLINE uint32_t lanes(uint32_t first_ray) const {
        return (uint32_t{blocks[first_ray / block_size]} >> (first_ray % block_size)) & all_lanes;
    }
    [[nodiscard]] HWY_INLINE bool empty() const {
        uint32_t any = 0;
        for (uint32_t b = 0; b < block_count; ++b) any |= blocks[b];
        return any == 0;
    }
    [[nodiscard]] HWY_INLINE uint32_t count() const {
        uint32_t count = 0;
        for (uint32_t b = 0; b < block_count; ++b) count += static_cast<uint32_t>(__builtin_popcount(blocks[b]));
        return count;
    }
    HWY_INLINE void clear() {
        for (uint32_t b = 0; b < block_count; ++b) blocks[b] = 0;
    }
    HWY_INLINE void add(uint32_t first_ray, uint32_t lane_bits) {
        blocks[first_ray / block_size] =
            static_cast<uint16_t>(blocks[first_ray / block_size] | lane_bits << (first_ray % block_size));
    }
    HWY_INLINE void remove(uint32_t first_ray, uint32_t lane_bits) {
        blocks[first_ray / block_size] =
            static_cast<uint16_t>(blocks[first_ray / block_size] & ~(lane_bits << (first_ray % block_size)));
    }
};

/// Which ray of a selection comes first.
HWY_INLINE uint32_t first_ray_of(const RaySelection &selection) {
    uint32_t block = 0;
    while (selection.blocks[block] == 0) ++block;
    return block * block_size + lowest_bit(selection.blocks[block]);
}

/// Which comes last.
HWY_INLINE uint32_t last_ray_of(const RaySelection &selection) {
    uint32_t block = block_count - 1;
    while (selection.blocks[block] == 0) --block;
    return block * block_size + (31 - static_cast<uint32_t>(__builtin_clz(selection.blocks[block])));
}

/// Calls visit(first_ray, lane_bits) for every vector of rays of which any is selected.
template <typename Visit> HWY_INLINE void for_each_vector(const RaySelection &selection, Visit &&visit) {
    for (uint32_t block = 0; block < block_count; ++block) {
        const uint32_t bits = selection.blocks[block];
        if (bits == 0) continue;
        for (uint32_t part = 0; part < block_size; part += lane_count) {
            const uint32_t lane_bits = (bits >> part) & all_lanes;
            if (lane_bits != 0) visit(block * block_size + part, lane_bits);
        }
    }
}

/// Calls visit(ray) for every selected ray; it may deselect that ray.
template <typename Visit> HWY_INLINE void for_each_ray(const RaySelection &selection, Visit &&visit) {
    for (uint32_t block = 0; block < block_count; ++block) {
        for (uint32_t bits = selection.blocks[block]; bits != 0; bits &= bits - 1) {
            visit(block * block_size + lowest_bit(bits));
        }
    }
}

struct alignas(64) RayGroup {
    float org_x[group_size], org_y[group_size], org_z[group_size]; ///< not read where all rays share an origin
    float dir_x[group_size], dir_y[group_size], dir_z[group_size];
    float t[group_size];              ///< in: hits must be nearer, or as near with a lower id; out: the hit's
    uint32_t triangle_id[group_size]; ///< out: what is hit; set to no_triangle before
    uint32_t left[group_size];        ///< the triangle that a ray leaves or, for shadow rays, is meant to reach
    Point3 shared_origin;

    [[nodiscard]] HWY_INLINE Points org(uint32_t first_ray) const {
        return {hn::Load(floats, org_x + first_ray), hn::Load(floats, org_y + first_ray),
                hn::Load(floats, org_z + first_ray)};
    }
    [[nodiscard]] HWY_INLINE Points dir(uint32_t first_ray) const {
        return {hn::Load(floats, dir_x + first_ray), hn::Load(floats, dir_y + first_ray),
                hn::Load(floats, dir_z + first_ray)};
    }
    [[nodiscard]] HWY_INLINE const float *org_row(int axis) const {
        return axis == 0 ? org_x : axis == 1 ? org_y : org_z;
    }
    [[nodiscard]] HWY_INLINE const float *dir_row(int axis) const {
        return axis == 0 ? dir_x : axis == 1 ? dir_y : dir_z;
    }
    HWY_INLINE void set_org(uint32_t first_ray, const Points &p) {
        hn::Store(p.x, floats, org_x + first_ray);
        hn::Store(p.y, floats, org_y + first_ray);
        hn::Store(p.z, floats, org_z + first_ray);
    }
    /// Makes the shared origin each ray's own, in a block.
    HWY_INLINE void spread_origin(uint32_t block) {
        for (uint32_t part = 0; part < block_size; part += lane_count) {
            set_org(block * block_size + part, splat(shared_origin));
        }
    }
    HWY_INLINE void set_dir(uint32_t first_ray, const Points &p) {
        hn::Store(p.x, floats, dir_x + first_ray);
        hn::Store(p.y, floats, dir_y + first_ray);
        hn::Store(p.z, floats, dir_z + first_ray);
    }
};

HWY_INLINE float coordinate(const Point3 &p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

} // namespace glint::HWY_NAMESPACE
