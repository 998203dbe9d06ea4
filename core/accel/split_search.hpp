// Looks for the best plane to split a cell at.
#pragma once

#include <span>

#include "accel/reference.hpp"
#include "accel/split.hpp"

namespace glint {

/// Counts references in evenly spaced bins along each axis (Popov et al. 2006, "Experiences with Streaming Construction
/// of SAH KD-Trees"; both ends of the bounds at once as in Shevtsov et al. 2007, "Highly Parallel Fast KD-tree
/// Construction for Interactive Ray Tracing of Dynamic Scenes"). Of each bin it also keeps how far in the references
/// begin and end: planes through these boundaries cut fewer triangles than planes between bins, on regular meshes none,
/// and can set triangles that lie in a face of the cell apart.
class SplitSearch {
public:
    /// Begins anew, for so many references that lie in `occupied`.
    void begin(const Box &occupied, size_t reference_count);
    /// Counts some of them.
    void add(std::span<const Reference> references);
    /// Takes over what another search, begun alike, has counted.
    void add(const SplitSearch &other);

    /// The cheapest split, or none where a leaf is cheaper or the cell has come to a limit. The cell holds the
    /// references that were counted and no others; after cutting off empty space nothing has to be counted again.
    [[nodiscard]] Split best(const Cell &cell) const;

private:
    static constexpr int32_t most_bins = 32;

    struct Bin {
        int32_t begins, ends; ///< of references in this bin
        float first_begin, last_end;
    };
    void offer_planes(Split &best, int axis, const Slices &slices) const;

    int32_t references_ = 0;
    int32_t bin_count_ = 0;  ///< none where only cutting off empty space can pay
    Box occupied_;           ///< holds all references
    Bin bins_[3][most_bins]; ///< for each axis
};

} // namespace glint
