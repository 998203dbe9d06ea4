// From the light that reaches a pixel to what a display is sent.
#pragma once

#include "math/pow.hpp"

namespace glint {

/// Through the tone curve c / (c + t), where there is one (t > 0), then through sRGB's transfer curve (IEC 61966-2-1),
/// if asked for. What is not above 0 becomes 0 on either way.
[[nodiscard]] inline float displayed(float c, float tone_scale, bool to_srgb) {
    if (tone_scale > 0.0f) {
        const float finite = c < 1e30f ? c : 1e30f;
        c = c > 0.0f ? finite / (finite + tone_scale) : 0.0f;
    }
    if (to_srgb) {
        const float clamped = c > 0.0f ? (c < 1.0f ? c : 1.0f) : 0.0f;
        c = clamped <= 0.0031308f ? 12.92f * clamped : 1.055f * pow_unit(clamped, 1.0f / 2.4f) - 0.055f;
    }
    return c;
}

} // namespace glint
