// Sizes in messages.
#pragma once

#include <string>

namespace glint::gles {

/// "640 x 480", of any integers.
template <typename Integer> [[nodiscard]] std::string size_text(Integer width_px, Integer height_px) {
    return std::to_string(width_px) + " x " + std::to_string(height_px);
}

} // namespace glint::gles
