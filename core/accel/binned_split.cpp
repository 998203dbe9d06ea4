// Split search for large cells: counts triangles in evenly spaced bins and looks at a few planes for each bin.
#include "accel/split.hpp"

#include <algorithm>

namespace glint {

namespace {

constexpr uint32_t most_bins = 32;
/// More references than this are judged by so many of them, spread evenly.
constexpr size_t sample_size = 1024;

/// The references that begin and end in one slice of the cell, and how far the slice's clear ends reach: between its
/// outermost boundaries and its own borders nothing begins or ends, so those boundaries are better planes.
struct Bin {
    uint32_t begins = 0, ends = 0;
    float first_begin = std::numeric_limits<float>::infinity();
    float last_end = -std::numeric_limits<float>::infinity();
};

/// Bins along one axis.
struct Bins {
    Bin bins[most_bins];
    uint32_t in_low_face = 0, in_high_face = 0;
};

} // namespace

Split find_binned_split(std::span<const Reference> references, const Box &cell, const CostModel &cost) {
    const auto count = static_cast<uint32_t>(references.size());
    const size_t samples = std::min(references.size(), sample_size);
    const uint32_t bin_count = samples < 128 ? most_bins / 2 : most_bins;
    Bins bins[3];
    float scale[3];
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = component(cell.hi, axis) - component(cell.lo, axis);
        scale[axis] = extent > 1e-30f ? static_cast<float>(bin_count) / extent : 0.0f;
    }
    const float last_bin = static_cast<float>(bin_count - 1);
    const size_t step = references.size() / samples;
    uint32_t random = 1;
    for (size_t i = 0; i < samples; ++i) {
        // Not just every n-th: meshes repeat themselves.
        random = random * 1664525u + 1013904223u; // Numerical Recipes' generator
        const Reference &reference = references[i * step + (step > 1 ? (random >> 8) % step : 0)];
        for (int axis = 0; axis < 3; ++axis) {
            const float lo = component(reference.bounds.lo, axis), hi = component(reference.bounds.hi, axis);
            const float cell_lo = component(cell.lo, axis);
            const auto begin_bin = static_cast<int32_t>(std::min((lo - cell_lo) * scale[axis], last_bin));
            const auto end_bin = static_cast<int32_t>(std::min((hi - cell_lo) * scale[axis], last_bin));
            Bins &b = bins[axis];
            Bin &begin = b.bins[begin_bin], &end = b.bins[end_bin];
            ++begin.begins;
            begin.first_begin = std::min(begin.first_begin, lo);
            ++end.ends;
            end.last_end = std::max(end.last_end, hi);
            b.in_low_face += hi <= cell_lo;
            b.in_high_face += lo >= component(cell.hi, axis);
        }
    }

    const float weight = static_cast<float>(count) / static_cast<float>(samples);
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        const Slices slices(cell, axis);
        if (slices.flat()) continue;
        const auto offer = [&](float plane, bool planar_to_lower, uint32_t lower_samples, uint32_t upper_samples) {
            const auto lower = static_cast<uint32_t>(weight * static_cast<float>(lower_samples));
            const auto upper = static_cast<uint32_t>(weight * static_cast<float>(upper_samples));
            const float c = cost.split(slices.lower_share(plane), lower, slices.upper_share(plane), upper);
            if (c < best.cost) best = {c, plane, axis, planar_to_lower, lower, upper};
        };
        const auto all = static_cast<uint32_t>(samples);
        const Bins &b = bins[axis];
        if (b.in_low_face > 0) offer(slices.lo, true, b.in_low_face, all - b.in_low_face);
        if (b.in_high_face > 0) offer(slices.hi, false, all - b.in_high_face, b.in_high_face);
        uint32_t begun = 0, ended = 0; // before this bin
        for (uint32_t i = 0; i < bin_count; ++i) {
            const Bin &bin = b.bins[i];
            // Where all that ends in the bin does so before anything begins there, no begins are below the last end.
            const bool apart = bin.last_end <= bin.first_begin;
            if (bin.ends > 0 && bin.last_end < slices.hi) {
                const uint32_t upper = all - ended - bin.ends;
                offer(bin.last_end, true, std::max(all - upper, begun + (apart ? 0 : bin.begins)), upper);
            }
            if (bin.begins > 0 && bin.first_begin > slices.lo) {
                offer(bin.first_begin, false, begun, std::max(all - begun, all - ended - (apart ? bin.ends : 0)));
            }
            begun += bin.begins;
            ended += bin.ends;
        }
    }
    return best;
}

} // namespace glint
