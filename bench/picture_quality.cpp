// How near one picture comes to another: the two measures that papers on scaling state.
#include "bench/picture_quality.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace glint::bench {
namespace {

constexpr double identical_db = 99.0;
constexpr size_t window_px = 11;
constexpr double window_sigma_px = 1.5;

/// Values in rows without gaps.
struct Plane {
    std::vector<double> values;
    size_t width;
    size_t height;
};

/// Brightness as ITU-R BT.601 weighs the channels, from 0 to 255.
Plane brightness(const PicturePixels &picture) {
    Plane plane{std::vector<double>(picture.rgba8.size() / 4), picture.width_px, picture.height_px};
    for (size_t i = 0; i < plane.values.size(); ++i) {
        const uint8_t *pixel = &picture.rgba8[4 * i];
        plane.values[i] = 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
    }
    return plane;
}

Plane product(const Plane &a, const Plane &b) {
    Plane result = a;
    for (size_t i = 0; i < a.values.size(); ++i) result.values[i] *= b.values[i];
    return result;
}

/// Bell-shaped weights whose sum is 1; equal ones where the window is wider than the picture.
std::vector<double> window_weights(size_t picture_size) {
    if (picture_size < window_px) return std::vector<double>(picture_size, 1.0 / static_cast<double>(picture_size));
    std::vector<double> weights(window_px);
    double sum = 0.0;
    for (size_t i = 0; i < window_px; ++i) {
        const double offset = static_cast<double>(i) - 0.5 * (window_px - 1);
        weights[i] = std::exp(-0.5 * offset * offset / (window_sigma_px * window_sigma_px));
        sum += weights[i];
    }
    for (double &weight : weights) weight /= sum;
    return weights;
}

/// The weighted mean of the window at every place where it fits.
Plane window_means(const Plane &plane) {
    const std::vector<double> across = window_weights(plane.width), down = window_weights(plane.height);
    Plane rows{{}, plane.width - across.size() + 1, plane.height};
    rows.values.resize(rows.width * rows.height);
    for (size_t y = 0; y < rows.height; ++y) {
        for (size_t x = 0; x < rows.width; ++x) {
            double sum = 0.0;
            for (size_t i = 0; i < across.size(); ++i) sum += across[i] * plane.values[y * plane.width + x + i];
            rows.values[y * rows.width + x] = sum;
        }
    }
    Plane means{{}, rows.width, plane.height - down.size() + 1};
    means.values.resize(means.width * means.height);
    for (size_t y = 0; y < means.height; ++y) {
        for (size_t i = 0; i < down.size(); ++i) {
            const double *row = &rows.values[(y + i) * rows.width];
            for (size_t x = 0; x < means.width; ++x) means.values[y * means.width + x] += down[i] * row[x];
        }
    }
    return means;
}

[[maybe_unused]] bool have_same_size(const PicturePixels &a, const PicturePixels &b) {
    return a.width_px == b.width_px && a.height_px == b.height_px && a.rgba8.size() == b.rgba8.size();
}

} // namespace

double psnr_db(const PicturePixels &a, const PicturePixels &b) {
    assert(have_same_size(a, b));
    double squares = 0.0;
    for (size_t i = 0; i < a.rgba8.size(); ++i) {
        if (i % 4 == 3) continue;
        const double difference = int{a.rgba8[i]} - int{b.rgba8[i]};
        squares += difference * difference;
    }
    if (squares == 0.0) return identical_db;
    const double mean_square = squares / (0.75 * static_cast<double>(a.rgba8.size()));
    return std::min(identical_db, 10.0 * std::log10(255.0 * 255.0 / mean_square));
}

double ssim(const PicturePixels &a, const PicturePixels &b) {
    assert(have_same_size(a, b));
    const Plane brightness_a = brightness(a), brightness_b = brightness(b);
    const Plane mean_a = window_means(brightness_a), mean_b = window_means(brightness_b);
    const Plane mean_aa = window_means(product(brightness_a, brightness_a));
    const Plane mean_bb = window_means(product(brightness_b, brightness_b));
    const Plane mean_ab = window_means(product(brightness_a, brightness_b));
    constexpr double c1 = (0.01 * 255.0) * (0.01 * 255.0), c2 = (0.03 * 255.0) * (0.03 * 255.0);
    double sum = 0.0;
    for (size_t i = 0; i < mean_a.values.size(); ++i) {
        const double ma = mean_a.values[i], mb = mean_b.values[i];
        const double variances = mean_aa.values[i] - ma * ma + mean_bb.values[i] - mb * mb;
        const double covariance = mean_ab.values[i] - ma * mb;
        sum += (2.0 * ma * mb + c1) * (2.0 * covariance + c2) / ((ma * ma + mb * mb + c1) * (variances + c2));
    }
    return sum / static_cast<double>(mean_a.values.size());
}

} // namespace glint::bench
