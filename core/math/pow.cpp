// x^y for highlights.
#include "math/pow.hpp"

#include <bit>
#include <cstdint>

namespace glint {

namespace {

/// log2 of a positive normal double. x = 2^e * m with m in [sqrt(1/2), sqrt(2)), and
/// log2(m) = 2/ln(2) * atanh((m - 1) / (m + 1)) by its odd power series: |s| < 0.1716, so eleven terms leave 2^-60.
double log2_of(double x) {
    uint64_t bits = std::bit_cast<uint64_t>(x);
    // Adding the distance from sqrt(1/2) to 1 before taking the exponent makes the mantissa's range start there.
    constexpr uint64_t sqrt_half = 0x3fe6a09e667f3bcd;
    constexpr uint64_t one = 0x3ff0000000000000;
    bits += one - sqrt_half;
    const int exponent = static_cast<int>(bits >> 52) - 1023;
    const double m = std::bit_cast<double>((bits & 0x000fffffffffffff) + sqrt_half);
    const double s = (m - 1.0) / (m + 1.0);
    const double s2 = s * s;
    double series = 1.0 / 21.0;
    for (int k = 19; k >= 1; k -= 2) series = series * s2 + 1.0 / k;
    constexpr double two_over_ln2 = 2.8853900817779268;
    return exponent + two_over_ln2 * (s * series);
}

/// 2^x for x in [-126.5, 0.5]: the nearest integer by exponent bits, the rest, |r| <= 1/2, by the Taylor series of
/// exp(r ln 2): fourteen terms leave 2^-60.
double exp2_of(double x) {
    constexpr double round_shift = 6755399441055744.0; // 1.5 * 2^52: adding it leaves the nearest integer
    const double nearest = (x + round_shift) - round_shift;
    constexpr double ln2 = 0.69314718055994531;
    const double r = (x - nearest) * ln2;
    double series = 1.0;
    for (int k = 14; k >= 1; --k) series = series * r / k + 1.0;
    const auto exponent = static_cast<int64_t>(nearest);
    return series * std::bit_cast<double>(static_cast<uint64_t>(exponent + 1023) << 52);
}

} // namespace

float pow_unit(float x, float y) {
    if (y == 0.0f || x >= 1.0f) return 1.0f;
    if (!(x > 0.0f)) return 0.0f;
    const double power = double(y) * log2_of(double(x)); // a float denormal is a normal double
    if (power < -126.0) return 0.0f;
    return static_cast<float>(exp2_of(power));
}

} // namespace glint
