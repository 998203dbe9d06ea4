// A scene's quadrics as rays find them: those with bounds in a hierarchy of boxes, the others beside it.
#pragma once

#include <cstdint>
#include <vector>

#include <glint/scene.hpp>

#include "accel/box_tree.hpp"
#include "math/box.hpp"

namespace glint {

/// Coefficients in double: intersection works in double throughout, and promotes nothing twice.
struct PlacedQuadric {
    double a, b, c, d, e, f, g, h, j, k;
    /// A point counts as the quadric's only inside of these. They hold all of it with room to spare, so this says
    /// nothing about the surface; it makes what rays hit independent of which boxes they looked into on the way.
    Box bounds;
    uint32_t id; ///< among all that rays can hit: behind the scene's triangles
};

struct QuadricTree {
    std::vector<PlacedQuadric> quadrics; ///< the unbounded ones, then leaf after leaf
    uint32_t unbounded_count = 0;
    std::vector<uint32_t> places; ///< where in `quadrics` the scene's quadrics are, in the scene's order
    std::vector<BoxNode> nodes;   ///< over those behind the unbounded ones, in their order; see box_tree.hpp
    Box bounds;                   ///< of the bounded ones

    /// Of all quadrics of the scene, where they stand.
    [[nodiscard]] static QuadricTree from(const Scene &scene);
};

} // namespace glint
