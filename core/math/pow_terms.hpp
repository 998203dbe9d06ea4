// The numbers behind pow_unit, shared by its scalar and its vector form so that both take the same steps.
#pragma once

#include <cstdint>

namespace glint::pow_terms {

/// Adding the distance from sqrt(1/2) to 1 before taking the exponent makes the mantissa's range start at sqrt(1/2).
inline constexpr uint32_t sqrt_half_bits = 0x3f3504f3, one_bits = 0x3f800000, mantissa_mask = 0x007fffff;

/// log2(m) = 2/ln(2) * atanh(s) with s = (m - 1) / (m + 1), |s| < 0.1716, as s * (log2_0 + s^2 (log2_1 + ...)):
/// what is left out is below 2^-29.
inline constexpr float log2_0 = 2.88539008f, log2_1 = 0.961796694f, log2_2 = 0.577078016f, log2_3 = 0.412198583f,
                       log2_4 = 0.320598898f;

/// 2^r for |r| <= 1/2 as 1 + r (exp2_1 + r (exp2_2 + ...)), the series of exp(r ln 2): what is left out is below 2^-27.
inline constexpr float exp2_1 = 0.693147181f, exp2_2 = 0.240226507f, exp2_3 = 5.55041087e-2f, exp2_4 = 9.61812911e-3f,
                       exp2_5 = 1.33335581e-3f, exp2_6 = 1.54035304e-4f, exp2_7 = 1.52527338e-5f;

/// Adding 1.5 * 2^23 and taking it away again leaves the nearest integer.
inline constexpr float round_shift = 12582912.0f;
/// Arguments below this count as 0, as do results.
inline constexpr float least_normal = 0x1p-126f;

} // namespace glint::pow_terms
