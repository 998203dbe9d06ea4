// Sums of samples, and the picture that their average is.
#include "view/average.hpp"

#include <algorithm>

#include "image/resolve.hpp"
#include "image/tone_curve.hpp"

namespace glint {

void add_to(float *sums, const float *light, size_t count) {
    for (size_t i = 0; i < count; ++i) sums[i] += light[i];
}

void show_average(const float *sums, const Averaging &how, size_t pixels, uint8_t *rgba8, float *radiance) {
    // Bytes of some pixels side by side first, alpha between them afterwards: compilers make vectors of such loops.
    constexpr size_t block_px = 256;
    float average[3 * block_px];
    uint8_t bytes[3 * block_px];
    const bool is_curved = how.tone_scale > 0.0f || how.to_srgb;
    for (size_t first = 0; first < pixels; first += block_px) {
        const size_t block = std::min(block_px, pixels - first);
        for (size_t i = 0; i < 3 * block; ++i) average[i] = sums[3 * first + i] * how.share;
        if (radiance) std::copy_n(average, 3 * block, radiance + 3 * first);
        if (is_curved) {
            for (size_t i = 0; i < 3 * block; ++i) average[i] = displayed(average[i], how.tone_scale, how.to_srgb);
        }
        for (size_t i = 0; i < 3 * block; ++i) bytes[i] = resolve_channel(average[i]);
        uint8_t *to = rgba8 + 4 * first;
        for (size_t i = 0; i < block; ++i, to += 4) {
            to[0] = bytes[3 * i];
            to[1] = bytes[3 * i + 1];
            to[2] = bytes[3 * i + 2];
            to[3] = 255;
        }
    }
}

} // namespace glint
