// Looks for the best plane to split a cell at.
#include "accel/split_search.hpp"

#include <algorithm>

#include "accel/cost_model.hpp"

namespace glint {

namespace {

/// Fewer bins where counting takes less time than comparing the planes.
int32_t bins_for(int32_t references) {
    return references < 64 ? 8 : 32;
}

} // namespace

void SplitSearch::begin(const Box &occupied, size_t reference_count) {
    occupied_ = occupied;
    references_ = static_cast<int32_t>(reference_count);
    bin_count_ = CostModel::may_pay(references_) ? bins_for(references_) : 0;
    for (Bin *bins : {bins_[0], bins_[1], bins_[2]}) {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        std::fill_n(bins, bin_count_, Bin{0, 0, infinity, -infinity});
    }
}

void SplitSearch::add(std::span<const Reference> references) {
    if (bin_count_ == 0) return;
    float base[6], scale[6]; // for the six numbers of a box
    for (int k = 0; k < 6; ++k) {
        const float extent = component(occupied_.hi, k % 3) - component(occupied_.lo, k % 3);
        base[k] = component(occupied_.lo, k % 3);
        scale[k] = extent > 1e-30f ? static_cast<float>(bin_count_) / extent : 0.0f;
    }
    const auto last_bin = static_cast<float>(bin_count_ - 1);
    for (const Reference &reference : references) {
        const float *const bounds = &reference.bounds.lo.x;
        int32_t bin[6];
        for (int k = 0; k < 6; ++k) bin[k] = static_cast<int32_t>(std::min((bounds[k] - base[k]) * scale[k], last_bin));
        for (int k = 0; k < 3; ++k) {
            const float lo = bounds[k], hi = bounds[k + 3];
            Bin &begin = bins_[k][bin[k]];
            ++begin.begins;
            begin.first_begin = std::min(begin.first_begin, lo);
            Bin &end = bins_[k][bin[k + 3]];
            ++end.ends;
            end.last_end = std::max(end.last_end, hi);
        }
    }
}

void SplitSearch::add(const SplitSearch &other) {
    for (int k = 0; k < 3; ++k) {
        for (int32_t i = 0; i < bin_count_; ++i) {
            Bin &bin = bins_[k][i];
            const Bin &others = other.bins_[k][i];
            bin.begins += others.begins;
            bin.ends += others.ends;
            bin.first_begin = std::min(bin.first_begin, others.first_begin);
            bin.last_end = std::max(bin.last_end, others.last_end);
        }
    }
}

Split SplitSearch::best(const Cell &cell) const {
    if (references_ == 0 || cell.levels_left == 0) return {};
    const CellSurface surface(cell.box);
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        const Slices slices = surface.across(axis);
        if (!slices.flat()) offer_planes(best, axis, slices);
    }
    const bool pays = best.cost < CostModel::leaf(references_);
    const bool fits = static_cast<double>(best.lower) + best.upper <= cell.reference_budget;
    return pays && fits ? best : Split{};
}

void SplitSearch::offer_planes(Split &best, int axis, const Slices &slices) const {
    const auto offer = [&](float plane, bool planar_to_lower, int32_t lower, int32_t upper) {
        const float cost = CostModel::split(slices.lower_share(plane), lower, slices.upper_share(plane), upper);
        if (cost < best.cost) best = {cost, plane, axis, planar_to_lower, lower, upper};
    };

    const float lo = component(occupied_.lo, axis), hi = component(occupied_.hi, axis);
    if (slices.lo < lo) offer(lo, false, 0, references_);
    if (hi < slices.hi) offer(hi, true, references_, 0);
    if (bin_count_ == 0) return;

    int32_t begun = 0, ended = 0; // before this bin
    for (int32_t i = 0; i < bin_count_; ++i) {
        const Bin &bin = bins_[axis][i];
        // Where all that ends in the bin does so before anything begins there, both planes are clear of the others.
        const bool apart = bin.last_end <= bin.first_begin;
        if (bin.ends > 0 && bin.last_end < slices.hi) {
            const int32_t upper = references_ - ended - bin.ends;
            offer(bin.last_end, true, std::max(references_ - upper, apart ? begun : begun + bin.begins), upper);
        }
        if (bin.begins > 0 && slices.lo < bin.first_begin) {
            const int32_t not_ended = references_ - ended;
            offer(bin.first_begin, false, begun,
                  std::max(references_ - begun, apart ? not_ended - bin.ends : not_ended));
        }
        begun += bin.begins;
        ended += bin.ends;
    }
}

} // namespace glint
