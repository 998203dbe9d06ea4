// How near one picture comes to another: the two measures that papers on scaling state.
#pragma once

#include <cstdint>
#include <span>

namespace glint::bench {

/// R, G, B, A bytes, rows without gaps. Alpha is not looked at.
struct PicturePixels {
    std::span<const uint8_t> rgba8; ///< 4 * width_px * height_px
    uint32_t width_px;
    uint32_t height_px;
};

/// Peak signal-to-noise ratio in decibels, of the red, green and blue bytes together; 99 for equal pictures. The
/// pictures have the same size.
[[nodiscard]] double psnr_db(const PicturePixels &a, const PicturePixels &b);

/// Structural similarity of the brightness, 1 for equal pictures: Z. Wang et al., "Image Quality Assessment: From Error
/// Visibility to Structural Similarity" (2004), with its Gaussian window of 11 x 11 pixels and its constants, averaged
/// over all places where the window fits (over the whole picture at once where it fits nowhere).
[[nodiscard]] double ssim(const PicturePixels &a, const PicturePixels &b);

} // namespace glint::bench
