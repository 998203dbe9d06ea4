// Vectors of as many floats as the instruction set has, for whitted_tile.cpp, which is compiled once for each.
//
// Arithmetic, comparisons and ?: are the compiler's own on its vector types; here is what it has no operators for.
#pragma once

#include <immintrin.h>

namespace glint::bench::embree::GLINT_PEER_ISA {

constexpr int width = GLINT_PEER_WIDTH;

using Float = float __attribute__((vector_size(4 * width)));
using Int = int __attribute__((vector_size(4 * width))); ///< as a mask: -1 = true, 0 = false

inline Float all(float x) {
    return Float{} + x;
}
inline Int all(int x) {
    return Int{} + x;
}

template <typename Vector> Vector load(const void *from) {
    return *static_cast<const Vector *>(from);
}
template <typename Vector> void store(void *to, const Vector &x) {
    *static_cast<Vector *>(to) = x;
}
template <typename Vector> void store_unaligned(void *to, const Vector &x) {
    __builtin_memcpy(to, &x, sizeof x);
}

inline Float max(const Float &a, const Float &b) {
    return a > b ? a : b;
}
inline Float min(const Float &a, const Float &b) {
    return a < b ? a : b;
}
inline Float abs(const Float &a) {
    return (Float)((Int)a & 0x7fffffff);
}

#if GLINT_PEER_WIDTH == 16

inline unsigned bits(const Int &mask) {
    return _mm512_movepi32_mask((__m512i)mask);
}
inline Float estimate_rsqrt(const Float &x) {
    return (Float)_mm512_rsqrt14_ps((__m512)x);
}
inline Float gather(const float *table, const Int &index) {
    return (Float)_mm512_i32gather_ps((__m512i)index, table, 4);
}
/// table[index] for a table of `width` entries.
inline Float look_up(const float *table, const Int &index) {
    return (Float)_mm512_permutexvar_ps((__m512i)index, _mm512_load_ps(table));
}
/// The elements that `mask` has, side by side from the first on.
inline Float compress(const Float &x, unsigned mask) {
    return (Float)_mm512_maskz_compress_ps(static_cast<__mmask16>(mask), (__m512)x);
}

#elif GLINT_PEER_WIDTH == 8

inline unsigned bits(const Int &mask) {
    return static_cast<unsigned>(_mm256_movemask_ps((__m256)mask));
}
inline Float estimate_rsqrt(const Float &x) {
    return (Float)_mm256_rsqrt_ps((__m256)x);
}
inline Float gather(const float *table, const Int &index) {
    return (Float)_mm256_i32gather_ps(table, (__m256i)index, 4);
}
inline Float look_up(const float *table, const Int &index) {
    return (Float)_mm256_permutevar8x32_ps(_mm256_load_ps(table), (__m256i)index);
}

#else

inline unsigned bits(const Int &mask) {
    return static_cast<unsigned>(_mm_movemask_ps((__m128)mask));
}
inline Float estimate_rsqrt(const Float &x) {
    return (Float)_mm_rsqrt_ps((__m128)x);
}
inline Float gather(const float *table, const Int &index) {
    return Float{table[index[0]], table[index[1]], table[index[2]], table[index[3]]};
}
inline Float look_up(const float *table, const Int &index) {
    return gather(table, index);
}

#endif

#if GLINT_PEER_WIDTH != 16
/// The elements that `mask` has, side by side from the first on.
inline Float compress(const Float &x, unsigned mask) {
    alignas(sizeof(Float)) float out[width] = {};
    int count = 0;
    for (int i = 0; i < width; ++i) {
        out[count] = x[i];
        count += static_cast<int>(mask >> i & 1u);
    }
    return load<Float>(out);
}
#endif

/// 1 / sqrt(x) to some 22 bits: an estimate and a step of Newton's.
inline Float rsqrt(const Float &x) {
    const Float y = estimate_rsqrt(x);
    return y * (1.5f - 0.5f * x * y * y);
}

/// log2 of positive normal numbers; the lowest value there is for zero.
inline Float log2(const Float &x) {
    // x = m 2^e with m in [sqrt(1/2), sqrt(2)); log2(m) by the series of artanh((m - 1) / (m + 1)).
    const Int offset = (Int)x - 0x3f3504f3;
    const Int exponent = offset >> 23;
    const Float m = (Float)((offset & 0x007fffff) + 0x3f3504f3);
    const Float s = (m - 1.0f) / (m + 1.0f), q = s * s;
    const Float series = ((0.41219858f * q + 0.57707802f) * q + 0.96179669f) * q + 2.8853901f;
    return __builtin_convertvector(exponent, Float) + s * series;
}

/// 2^x; 2^-126 below that.
inline Float exp2(const Float &x) {
    const Float clamped = max(x, all(-126.0f));
    // Adding 1.5 * 2^23 leaves the nearest whole number in the lowest bits.
    const Float shifted = clamped + 12582912.0f;
    const Int whole = (Int)shifted - 0x4b400000;
    const Float f = clamped - __builtin_convertvector(whole, Float);
    const Float p =
        ((((0.0013333558f * f + 0.0096181291f) * f + 0.055504109f) * f + 0.24022651f) * f + 0.69314718f) * f + 1.0f;
    return (Float)((Int)p + (whole << 23));
}

/// x^y for x in [0, 1], y >= 0.
inline Float power(const Float &x, const Float &y) {
    return exp2(y * log2(x));
}

} // namespace glint::bench::embree::GLINT_PEER_ISA
