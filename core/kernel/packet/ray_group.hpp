// Up to 256 rays that are traced together, coordinate by coordinate.
#pragma once

#include <type_traits>

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
    /// Four blocks as one number: bit r of the q-th stands for ray 64 q + r.
    static constexpr uint32_t quad_count = block_count / 4;
    [[nodiscard]] HWY_INLINE uint64_t quad(uint32_t number) const {
        uint64_t bits;
        __builtin_memcpy(&bits, blocks + 4 * number, sizeof(bits));
        return bits;
    }
    [[nodiscard]] HWY_INLINE bool empty() const {
        uint64_t any = 0;
        for (uint32_t q = 0; q < quad_count; ++q) any |= quad(q);
        return any == 0;
    }
    [[nodiscard]] HWY_INLINE uint32_t count() const {
        int count = 0;
        for (uint32_t q = 0; q < quad_count; ++q) count += __builtin_popcountll(quad(q));
        return static_cast<uint32_t>(count);
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
    uint32_t q = 0;
    while (selection.quad(q) == 0) ++q;
    return q * 64 + static_cast<uint32_t>(__builtin_ctzll(selection.quad(q)));
}

/// Which comes last.
HWY_INLINE uint32_t last_ray_of(const RaySelection &selection) {
    uint32_t q = RaySelection::quad_count - 1;
    while (selection.quad(q) == 0) --q;
    return q * 64 + (63 - static_cast<uint32_t>(__builtin_clzll(selection.quad(q))));
}

/// Bit v for every vector of rays of which any is selected, where a vector's bits are whole bytes.
HWY_INLINE uint32_t vectors_with_rays(const RaySelection &selection) {
    using Bits = std::conditional_t<lane_count == 16, uint16_t, uint8_t>;
    constexpr hn::CappedTag<Bits, 2 * block_count / sizeof(Bits)> bits;
    constexpr uint32_t at_once = hn::MaxLanes(bits);
    const auto *from = reinterpret_cast<const Bits *>(selection.blocks);
    uint32_t vectors = 0;
    for (uint32_t v = 0; v < group_size / lane_count; v += at_once) {
        vectors |= bits_of(bits, hn::Ne(hn::LoadU(bits, from + v), hn::Zero(bits))) << v;
    }
    return vectors;
}

/// Bit v for every vector of rays in blocks whose bits are set.
HWY_INLINE constexpr uint32_t vectors_of(uint32_t blocks) {
    if constexpr (lane_count == block_size) return blocks;
    uint32_t spread = blocks; // so that there is room for a second bit behind each
    spread = (spread | spread << 8) & 0x00ff00ff;
    spread = (spread | spread << 4) & 0x0f0f0f0f;
    spread = (spread | spread << 2) & 0x33333333;
    spread = (spread | spread << 1) & 0x55555555;
    return spread | spread << 1;
}

inline constexpr uint32_t all_blocks = (1u << block_count) - 1;

/// Calls visit(first_ray, lane_bits) for every vector of rays of which any is selected, in those blocks whose bits are
/// set; it may deselect those rays.
template <typename Visit>
HWY_INLINE void for_each_vector(const RaySelection &selection, uint32_t blocks, Visit &&visit) {
    if constexpr (lane_count >= 8) {
        for (uint32_t rest = vectors_with_rays(selection) & vectors_of(blocks); rest != 0; rest &= rest - 1) {
            const uint32_t first_ray = lowest_bit(rest) * lane_count;
            visit(first_ray, selection.lanes(first_ray));
        }
    } else {
        for (; blocks != 0; blocks &= blocks - 1) {
            const uint32_t block = lowest_bit(blocks), bits = selection.blocks[block];
            if (bits == 0) continue;
            for (uint32_t part = 0; part < block_size; part += lane_count) {
                const uint32_t lane_bits = (bits >> part) & all_lanes;
                if (lane_bits != 0) visit(block * block_size + part, lane_bits);
            }
        }
    }
}
template <typename Visit> HWY_INLINE void for_each_vector(const RaySelection &selection, Visit &&visit) {
    for_each_vector(selection, all_blocks, visit);
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
        const float *const rows[3] = {org_x, org_y, org_z};
        return rows[axis];
    }
    [[nodiscard]] HWY_INLINE const float *dir_row(int axis) const {
        const float *const rows[3] = {dir_x, dir_y, dir_z};
        return rows[axis];
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
    const float coordinates[3] = {p.x, p.y, p.z};
    return coordinates[axis];
}

} // namespace glint::HWY_NAMESPACE
