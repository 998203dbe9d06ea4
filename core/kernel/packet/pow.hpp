// pow_unit of math/pow.hpp for every lane: the same steps, the same bits.
#pragma once

#include "kernel/packet/lanes.hpp"
#include "math/pow_terms.hpp"

namespace glint::HWY_NAMESPACE {

HWY_INLINE Floats log2_of(Floats x) {
    namespace p = pow_terms;
    const Uints bits = hn::BitCast(uints, x) + hn::Set(uints, p::one_bits - p::sqrt_half_bits);
    const Ints shifted = hn::BitCast(ints, hn::ShiftRight<23>(bits));
    const Floats exponent = hn::ConvertTo(floats, shifted - hn::Set(ints, 127));
    const Uints mantissa = hn::And(bits, hn::Set(uints, p::mantissa_mask)) + hn::Set(uints, p::sqrt_half_bits);
    const Floats m = hn::BitCast(floats, mantissa);
    const Floats s = (m - splat(1.0f)) / (m + splat(1.0f));
    const Floats s2 = s * s;
    Floats series = splat(p::log2_4) * s2 + splat(p::log2_3);
    series = series * s2 + splat(p::log2_2);
    series = series * s2 + splat(p::log2_1);
    series = series * s2 + splat(p::log2_0);
    return exponent + s * series;
}

HWY_INLINE Floats exp2_of(Floats x) {
    namespace p = pow_terms;
    const Floats nearest = (x + splat(p::round_shift)) - splat(p::round_shift);
    const Floats r = x - nearest;
    Floats series = splat(p::exp2_7) * r + splat(p::exp2_6);
    series = series * r + splat(p::exp2_5);
    series = series * r + splat(p::exp2_4);
    series = series * r + splat(p::exp2_3);
    series = series * r + splat(p::exp2_2);
    series = series * r + splat(p::exp2_1);
    series = series * r + splat(1.0f);
    const Ints exponent = hn::ConvertTo(ints, nearest) + hn::Set(ints, 127);
    return series * hn::BitCast(floats, hn::ShiftLeft<23>(exponent));
}

/// x in [0, 1], y in [0, 1e6].
HWY_INLINE Floats pow_unit(Floats x, Floats y) {
    namespace p = pow_terms;
    const Floats power = y * log2_of(x);
    const FloatMask vanishes = hn::Or(hn::Lt(power, splat(-126.0f)), hn::Lt(x, splat(p::least_normal)));
    const FloatMask is_one = hn::Or(hn::Eq(y, hn::Zero(floats)), hn::Ge(x, splat(1.0f)));
    const Floats result = exp2_of(hn::IfThenElseZero(hn::Not(vanishes), power));
    return hn::IfThenElse(is_one, splat(1.0f), hn::IfThenElseZero(hn::Not(vanishes), result));
}

} // namespace glint::HWY_NAMESPACE
