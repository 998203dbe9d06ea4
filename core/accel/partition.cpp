// Shares references out to the two sides of a split.
#include "accel/partition.hpp"

namespace glint {

namespace {

/// Decides sides without branches: which side the next triangle is on is not to be foreseen.
struct Sides {
    int axis;
    float position;
    float planar_below, planar_above; ///< the position for the side that gets triangles in the plane, else out of reach

    explicit Sides(const Split &split)
        : axis(split.axis),
          position(split.position),
          planar_below(split.planar_to_lower ? position : -std::numeric_limits<float>::infinity()),
          planar_above(split.planar_to_lower ? std::numeric_limits<float>::infinity() : position) {}

    [[nodiscard]] bool lower(const Box &bounds) const {
        return static_cast<bool>(int(component(bounds.lo, axis) < position) |
                                 int(component(bounds.hi, axis) <= planar_below));
    }
    [[nodiscard]] bool upper(const Box &bounds) const {
        return static_cast<bool>(int(component(bounds.hi, axis) > position) |
                                 int(component(bounds.lo, axis) >= planar_above));
    }
};

} // namespace

SideCounts count_sides(std::span<const Reference> references, const Split &split) {
    const Sides sides(split);
    SideCounts counts;
    for (const Reference &reference : references) {
        counts.lower += sides.lower(reference.bounds);
        counts.upper += sides.upper(reference.bounds);
    }
    return counts;
}

SideCounts Partition::share_out(std::span<const Reference> references, const Split &split, Reference *lower,
                                Reference *upper) {
    const Sides sides(split);
    if (straddlers_.size() < references.size()) straddlers_.resize(references.size());
    SideCounts counts;
    size_t straddler_count = 0; // here and not in *this: in a register
    for (const Reference &from : references) {
        const Reference reference = from;
        const bool to_lower = sides.lower(reference.bounds), to_upper = sides.upper(reference.bounds);
        lower[counts.lower] = reference;
        upper[counts.upper] = reference;
        straddlers_[straddler_count] = {static_cast<uint32_t>(counts.lower), static_cast<uint32_t>(counts.upper)};
        straddler_count += static_cast<size_t>(int(to_lower) & int(to_upper));
        counts.lower += to_lower;
        counts.upper += to_upper;
    }
    straddler_count_ = straddler_count;
    return counts;
}

SideCounts Partition::divide(std::span<const Reference> references, const Split &split, Reference *lower,
                             Reference *upper) {
    SideCounts counts = share_out(references, split, lower, upper);
    // From the last to the first, so that the last reference, which fills the gap of a dropped one, is cut already.
    while (straddler_count_ > 0) {
        const Straddler &at = straddlers_[--straddler_count_];
        Reference &low = lower[at.lower], &high = upper[at.upper];
        const auto [below, above] = cut(triangles_[low.triangle_id], low.bounds, split.axis, split.position);
        low.bounds = below;
        high.bounds = above;
        if (below.empty()) low = lower[--counts.lower];
        if (above.empty()) high = upper[--counts.upper];
    }
    return counts;
}

void Partition::divide_as_counted(std::span<const Reference> references, const Split &split, Reference *lower,
                                  Reference *upper) {
    share_out(references, split, lower, upper);
    for (size_t i = 0; i < straddler_count_; ++i) {
        Box &low = lower[straddlers_[i].lower].bounds, &high = upper[straddlers_[i].upper].bounds;
        const uint32_t id = lower[straddlers_[i].lower].triangle_id;
        const auto [below, above] = cut(triangles_[id], low, split.axis, split.position);
        component(low.hi, split.axis) = component(high.lo, split.axis) = split.position;
        if (!below.empty()) low = below;
        if (!above.empty()) high = above;
    }
}

} // namespace glint
