// x^y for highlights.
#include "math/pow.hpp"

#include <cstdint>

#include "math/bits.hpp"
#include "math/pow_terms.hpp"

namespace glint {

namespace {

using namespace pow_terms;

/// log2 of a positive normal float: x = 2^e * m with m in [sqrt(1/2), sqrt(2)).
float log2_of(float x) {
    const uint32_t bits = bit_cast<uint32_t>(x) + (one_bits - sqrt_half_bits);
    const auto exponent = static_cast<float>(static_cast<int32_t>(bits >> 23) - 127);
    const float m = bit_cast<float>((bits & mantissa_mask) + sqrt_half_bits);
    const float s = (m - 1.0f) / (m + 1.0f);
    const float s2 = s * s;
    const float series = (((log2_4 * s2 + log2_3) * s2 + log2_2) * s2 + log2_1) * s2 + log2_0;
    return exponent + s * series;
}

/// 2^x for x in [-126, 0.5].
float exp2_of(float x) {
    const float nearest = (x + round_shift) - round_shift;
    const float r = x - nearest;
    const float series =
        ((((((exp2_7 * r + exp2_6) * r + exp2_5) * r + exp2_4) * r + exp2_3) * r + exp2_2) * r + exp2_1) * r + 1.0f;
    return series * bit_cast<float>(static_cast<uint32_t>(static_cast<int32_t>(nearest) + 127) << 23);
}

} // namespace

float pow_unit(float x, float y) {
    if (y == 0.0f || x >= 1.0f) return 1.0f;
    if (x < least_normal) return 0.0f;
    const float power = y * log2_of(x);
    return power < -126.0f ? 0.0f : exp2_of(power);
}

} // namespace glint
