// A cell of the tree while it is being built.
#pragma once

#include <cstdint>

#include "math/box.hpp"

namespace glint {

struct Cell {
    Box box;
    /// Levels that the subtree in this cell may have below its root.
    uint32_t levels_left = 0;
    /// References that the subtree's leaves may hold together. Where triangles cross each other wildly every split
    /// copies most of them; this ends it. (Stich et al. 2009 share out a budget for the same reason.)
    double reference_budget = 0.0;
};

} // namespace glint
