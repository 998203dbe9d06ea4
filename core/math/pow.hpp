// x^y for highlights, from + - * / and bit patterns alone: the same bits on every machine, unlike libm's pow.
#pragma once

namespace glint {

/// x^y for x in [0, 1] and y in [0, 1e6]; pow_unit(0, 0) = 1.
/// Computed in float as exp2(y * log2(x)). The relative error is below 2^-21 + 2^-23 * |y log2(x)|: it grows with
/// smallness, as the rounding of the exponent has it, and reaches 2^-16 at 2^-126; below that the result is 0, as it is
/// for y > 0 and an x below 2^-126 (tested against std::pow in double).
[[nodiscard]] float pow_unit(float x, float y);

} // namespace glint
