// Builds the top of the tree, all threads at once, down to cells that are small enough for one thread each.
#pragma once

#include <vector>

#include "accel/partition.hpp"
#include "threads/crew.hpp"

namespace glint {

/// A split with its two branches, or a cell whose subtree has yet to be built.
struct Branch {
    Split split;                   ///< exists() unless the branch ends in a cell
    uint32_t lower = 0, upper = 0; ///< branches
    uint32_t cell = 0;             ///< number of the cell
};

/// A cell and all that lies in it.
struct FilledCell {
    Cell cell;
    uint32_t branch = 0; ///< that ends here, or would
    Box occupied;        ///< holds all references
    UninitializedVector<Reference> references;
};

struct TopOfTree {
    std::vector<Branch> branches; ///< branches[0] is the root
    std::vector<FilledCell> cells;
};

/// Splits the root and what comes of it level by level.
[[nodiscard]] TopOfTree build_top(FilledCell root, std::span<const TriangleCorners> triangles, const Crew &crew);

} // namespace glint
