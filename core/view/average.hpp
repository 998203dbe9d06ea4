// Sums of samples, and the picture that their average is.
#pragma once

#include <cstddef>
#include <cstdint>

namespace glint {

/// Adds so many numbers to so many sums.
void add_to(float *sums, const float *light, size_t count);

/// How sums become a picture.
struct Averaging {
    float share;      ///< of each sample in the average
    float tone_scale; ///< 0 = no tone curve
    bool to_srgb;
};

/// Writes the averages of pixels with R, G, B sums: as R, G, B, A bytes and, where `radiance` is not nullptr, as they
/// are.
void show_average(const float *sums, const Averaging &how, size_t pixels, uint8_t *rgba8, float *radiance);

} // namespace glint
