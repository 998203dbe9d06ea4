// x^y for highlights, from + - * / and bit patterns alone: the same bits on every machine, unlike libm's pow.
#pragma once

namespace glint {

/// x^y for x in [0, 1] and y in [0, 1e6]; pow_unit(0, 0) = 1.
/// Computed in double as exp2(y * log2(x)) and rounded once: the error is below 0.501 units in the last place of the
/// result where that is a normal float (tested against std::pow in long double); results below 2^-126 are 0.
[[nodiscard]] float pow_unit(float x, float y);

} // namespace glint
