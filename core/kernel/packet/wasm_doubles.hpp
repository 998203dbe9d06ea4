// What Highway leaves out for WebAssembly up to version 1.0: the few operations on doubles that the kernels need.
#pragma once

#include <hwy/highway.h>

#if HWY_TARGET == HWY_WASM && !HWY_HAVE_FLOAT64
namespace hwy::HWY_NAMESPACE {

using TwoDoubles = Vec128<double, 2>;
using TwoFloats = Vec128<float, 2>;

HWY_API TwoDoubles Set(Simd<double, 2, 0>, double value) {
    return TwoDoubles{wasm_f64x2_splat(value)};
}
HWY_API TwoDoubles operator+(TwoDoubles a, TwoDoubles b) {
    return TwoDoubles{wasm_f64x2_add(a.raw, b.raw)};
}
HWY_API TwoDoubles operator-(TwoDoubles a, TwoDoubles b) {
    return TwoDoubles{wasm_f64x2_sub(a.raw, b.raw)};
}
HWY_API TwoDoubles operator*(TwoDoubles a, TwoDoubles b) {
    return TwoDoubles{wasm_f64x2_mul(a.raw, b.raw)};
}
HWY_API TwoDoubles operator/(TwoDoubles a, TwoDoubles b) {
    return TwoDoubles{wasm_f64x2_div(a.raw, b.raw)};
}
HWY_API TwoDoubles Neg(TwoDoubles a) {
    return TwoDoubles{wasm_f64x2_neg(a.raw)};
}
HWY_API TwoDoubles Sqrt(TwoDoubles a) {
    return TwoDoubles{wasm_f64x2_sqrt(a.raw)};
}
using TwoBools = Mask128<double, 2>;
HWY_API TwoBools operator==(TwoDoubles a, TwoDoubles b) {
    return TwoBools{wasm_f64x2_eq(a.raw, b.raw)};
}
HWY_API TwoBools operator<(TwoDoubles a, TwoDoubles b) {
    return TwoBools{wasm_f64x2_lt(a.raw, b.raw)};
}
HWY_API TwoBools operator<=(TwoDoubles a, TwoDoubles b) {
    return TwoBools{wasm_f64x2_le(a.raw, b.raw)};
}
HWY_API TwoBools operator>=(TwoDoubles a, TwoDoubles b) {
    return TwoBools{wasm_f64x2_ge(a.raw, b.raw)};
}
HWY_API TwoDoubles PromoteTo(Simd<double, 2, 0>, TwoFloats a) {
    return TwoDoubles{wasm_f64x2_promote_low_f32x4(a.raw)};
}
HWY_API TwoFloats DemoteTo(Simd<float, 2, 0>, TwoDoubles a) {
    return TwoFloats{wasm_f32x4_demote_f64x2_zero(a.raw)};
}

} // namespace hwy::HWY_NAMESPACE
#endif
