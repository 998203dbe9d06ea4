// The vector vocabulary of the packet kernels: Highway's types for the one instruction set a file is compiled for.
// Headers in this folder are included by the kernel_<isa>.cpp files only. All they define lies in a namespace of the
// instruction set's own, and nothing in them may leave an inline function or template of another namespace behind: the
// linker would be free to let the rest of the program use a copy with wide instructions in it.
#pragma once

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "kernel/packet/wasm_doubles.hpp"

namespace glint::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::ScalableTag<int32_t>;
using UintTag = hn::ScalableTag<uint32_t>;
using DoubleTag = hn::ScalableTag<double>;
using HalfFloatTag = hn::Half<FloatTag>; ///< as many floats as a vector holds doubles

using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
using Uints = hn::Vec<UintTag>;
using Doubles = hn::Vec<DoubleTag>;
using FloatMask = hn::Mask<FloatTag>;

inline constexpr FloatTag floats;
inline constexpr IntTag ints;
inline constexpr UintTag uints;
inline constexpr DoubleTag doubles;
inline constexpr HalfFloatTag half_floats;

inline constexpr uint32_t lane_count = HWY_MAX_BYTES / sizeof(float);
inline constexpr uint32_t all_lanes = lane_count == 32 ? ~0u : (1u << lane_count) - 1;

/// The smaller and larger of scalars, without <algorithm>.
template <typename T> HWY_INLINE T smaller(T a, T b) {
    return a < b ? a : b;
}
template <typename T> HWY_INLINE T larger(T a, T b) {
    return a > b ? a : b;
}
HWY_INLINE float magnitude(float a) {
    return __builtin_fabsf(a);
}
HWY_INLINE uint32_t lowest_bit(uint32_t bits) {
    return static_cast<uint32_t>(__builtin_ctz(bits));
}

HWY_INLINE Floats splat(float value) {
    return hn::Set(floats, value);
}

/// A narrower vector where there is less to fill it with: a wide node has eight children, its leaves no more triangles.
using NarrowTag = hn::CappedTag<float, 8>;
using NarrowFloats = hn::Vec<NarrowTag>;
using NarrowMask = hn::Mask<NarrowTag>;
inline constexpr NarrowTag narrow_floats;
inline constexpr uint32_t narrow_lanes = lane_count < 8 ? lane_count : 8;

HWY_INLINE NarrowFloats narrow_splat(float value) {
    return hn::Set(narrow_floats, value);
}

/// Lane i of a mask as bit i, and back.
template <typename Tag> HWY_INLINE uint32_t bits_of(Tag tag, hn::Mask<Tag> mask) {
#if HWY_TARGET == HWY_AVX3
    (void)tag;
    return mask.raw; // by way of memory it takes several times as long
#else
    uint64_t bits = 0;
    hn::StoreMaskBits(tag, mask, reinterpret_cast<uint8_t *>(&bits));
    return static_cast<uint32_t>(bits) & (~0u >> (32 - hn::MaxLanes(tag)));
#endif
}
HWY_INLINE uint32_t bits_of(FloatMask mask) {
    return bits_of(floats, mask);
}
HWY_INLINE FloatMask mask_of(uint32_t bits) {
#if HWY_TARGET == HWY_AVX3
    return FloatMask{static_cast<__mmask16>(bits)};
#else
    const uint64_t bytes = bits;
    return hn::LoadMaskBits(floats, reinterpret_cast<const uint8_t *>(&bytes));
#endif
}

/// Numbers of a vector's lanes, or of bytes, those first whose bits are set: a row for each set of bits.
template <uint32_t lanes, uint32_t bytes_each> struct ChosenRows {
    alignas(64) uint8_t rows[1u << lanes][lanes * bytes_each] = {};

    constexpr ChosenRows() {
        for (uint32_t bits = 0; bits < 1u << lanes; ++bits) {
            uint32_t to = 0;
            for (uint32_t from = 0; from < lanes * bytes_each; ++from) {
                if ((bits >> (from / bytes_each) & 1) != 0) rows[bits][to++] = static_cast<uint8_t>(from);
            }
        }
    }
};

/// Writes those of a vector's numbers whose bits are set, in their order; returns how many. A vector is written,
/// whatever the bits are. (But for AVX-512, Highway's Compress() has a table of a kilobyte, which gcc 12 copies at each
/// call.)
HWY_INLINE uint32_t put_chosen(Uints numbers, uint32_t bits, uint32_t *to) {
#if HWY_TARGET == HWY_AVX3
    // To a register first: straight to memory takes a hundred cycles on some processors.
    hn::StoreU(hn::Compress(numbers, hn::RebindMask(uints, mask_of(bits))), uints, to);
#elif HWY_TARGET == HWY_AVX2
    static constexpr ChosenRows<8, 1> chosen;
    const auto order = hn::PromoteTo(uints, hn::Load(hn::Rebind<uint8_t, UintTag>(), chosen.rows[bits]));
    // What Highway has for it calls its abort() in builds with assertions.
    hn::StoreU(Uints{_mm256_permutevar8x32_epi32(numbers.raw, order.raw)}, uints, to);
#else
    static constexpr ChosenRows<4, 4> chosen;
    const hn::Repartition<uint8_t, UintTag> bytes;
    const auto order = hn::Load(bytes, chosen.rows[bits]);
    hn::StoreU(hn::BitCast(uints, hn::TableLookupBytes(hn::BitCast(bytes, numbers), order)), uints, to);
#endif
    return static_cast<uint32_t>(__builtin_popcount(bits));
}

HWY_INLINE Floats min3(Floats a, Floats b, Floats c) {
    return hn::Min(hn::Min(a, b), c);
}
HWY_INLINE Floats max3(Floats a, Floats b, Floats c) {
    return hn::Max(hn::Max(a, b), c);
}
HWY_INLINE float least_lane(Floats a) {
    return hn::GetLane(hn::MinOfLanes(floats, a));
}
HWY_INLINE float greatest_lane(Floats a) {
    return hn::GetLane(hn::MaxOfLanes(floats, a));
}

/// A vector of floats as doubles: the lower lanes, the upper lanes.
struct DoubleLanes {
    Doubles lower, upper;
};
HWY_INLINE DoubleLanes promote(Floats a) {
    return {hn::PromoteTo(doubles, hn::LowerHalf(half_floats, a)),
            hn::PromoteTo(doubles, hn::UpperHalf(half_floats, a))};
}
HWY_INLINE Floats demote(DoubleLanes a) {
    return hn::Combine(floats, hn::DemoteTo(half_floats, a.upper), hn::DemoteTo(half_floats, a.lower));
}

/// Three coordinates of lane_count points or vectors.
struct Points {
    Floats x, y, z;
};
HWY_INLINE Floats dot(const Points &a, const Points &b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

/// With fewer roundings where a machine has an instruction for it, so that it is not the same on every machine: only
/// for what is compared with a margin.
template <typename V> HWY_INLINE V fused_dot(V ax, V ay, V az, V bx, V by, V bz) {
    return hn::MulAdd(ax, bx, hn::MulAdd(ay, by, az * bz));
}
HWY_INLINE Floats fused_dot(const Points &a, const Points &b) {
    return fused_dot(a.x, a.y, a.z, b.x, b.y, b.z);
}

HWY_INLINE Floats max_abs(const Points &p) {
    return max3(hn::Abs(p.x), hn::Abs(p.y), hn::Abs(p.z));
}

HWY_INLINE Floats sum_abs(const Points &p) {
    return (hn::Abs(p.x) + hn::Abs(p.y)) + hn::Abs(p.z);
}

HWY_INLINE Points scaled(const Points &p, Floats s) {
    return {p.x * s, p.y * s, p.z * s};
}
HWY_INLINE Points sum(const Points &a, const Points &b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Points product(const Points &a, const Points &b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
HWY_INLINE Points difference(const Points &a, const Points &b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Points normalized(const Points &p) {
    return scaled(p, splat(1.0f) / hn::Sqrt(dot(p, p)));
}
HWY_INLINE Points either(FloatMask first, const Points &a, const Points &b) {
    return {hn::IfThenElse(first, a.x, b.x), hn::IfThenElse(first, a.y, b.y), hn::IfThenElse(first, a.z, b.z)};
}

/// Three coordinates of one point or vector.
struct Point3 {
    float x, y, z;
};
HWY_INLINE Point3 cross(const Point3 &a, const Point3 &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE float max_abs(const Point3 &p) {
    return larger(larger(magnitude(p.x), magnitude(p.y)), magnitude(p.z));
}
HWY_INLINE float sum_abs(const Point3 &p) {
    return (magnitude(p.x) + magnitude(p.y)) + magnitude(p.z);
}
HWY_INLINE Points splat(const Point3 &p) {
    return {splat(p.x), splat(p.y), splat(p.z)};
}

} // namespace glint::HWY_NAMESPACE
