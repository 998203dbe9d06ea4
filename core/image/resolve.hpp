// From linear colour to eight bits.
#pragma once

#include <cstdint>

namespace glint {

/// round(255 * clamp(c, 0, 1)), halves up, exactly: adding 0.5 before truncating would round the float just below a
/// half the wrong way. NaN becomes 0.
[[nodiscard]] inline uint8_t resolve_channel(float c) {
    const float clamped = c > 0.0f ? (c < 1.0f ? c : 1.0f) : 0.0f;
    const float scaled = 255.0f * clamped;
    const auto whole = static_cast<int>(scaled);
    const float rest = scaled - static_cast<float>(whole);
    return static_cast<uint8_t>(whole + (rest >= 0.5f ? 1 : 0));
}

} // namespace glint
