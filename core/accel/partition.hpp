// Shares a cell's references out to the two cells that a split makes of it.
#pragma once

#include <span>
#include <vector>

#include "accel/reference.hpp"
#include "accel/split.hpp"
#include "accel/uninitialized_vector.hpp"

namespace glint {

struct SideCounts {
    size_t lower = 0, upper = 0;
};

/// How many references will go to either side.
[[nodiscard]] SideCounts count_sides(std::span<const Reference> references, const Split &split);

/// One for each thread: what dividing needs for the while.
class Partition {
public:
    explicit Partition(std::span<const TriangleCorners> triangles) : triangles_(triangles) {}

    /// Writes what lies on either side to `lower`, which may be where the references are, and to `upper`, which may
    /// not; cuts what straddles the plane and drops parts that turn out empty. Both have room for all references.
    SideCounts divide(std::span<const Reference> references, const Split &split, Reference *lower, Reference *upper);

    /// The same, but keeps empty parts, whole as far as the plane: as many arrive as count_sides() said.
    void divide_as_counted(std::span<const Reference> references, const Split &split, Reference *lower,
                           Reference *upper);

private:
    struct Straddler {
        uint32_t lower, upper; ///< where its parts are
    };
    SideCounts share_out(std::span<const Reference> references, const Split &split, Reference *lower, Reference *upper);

    std::span<const TriangleCorners> triangles_;
    UninitializedVector<Straddler> straddlers_;
    size_t straddler_count_ = 0;
};

} // namespace glint
