// The size of a picture that is shown larger than it is.
#include <glint/governor.hpp>

#include <algorithm>
#include <cmath>

namespace glint {

PictureSize scaled_size(uint32_t width_px, uint32_t height_px, float scale) {
    const PictureSize whole{std::max(width_px, 1u), std::max(height_px, 1u)};
    if (!(scale < 1.0f)) return whole;
    uint32_t grain_px = 8;
    while (grain_px > 1 && grain_px * 256 > whole.width_px) grain_px /= 2;
    const double grains = std::round(static_cast<double>(whole.width_px) * std::max(scale, 0.0f) / grain_px);
    const double width = std::clamp(grains * grain_px, 1.0, static_cast<double>(whole.width_px));
    const double height = std::round(width * whole.height_px / whole.width_px);
    return {static_cast<uint32_t>(width), std::max(static_cast<uint32_t>(height), 1u)};
}

} // namespace glint
