// One toothed wheel: an involute gear with hub, web and rim, its web solid or cut into spokes.
#pragma once

#include <cstdint>
#include <vector>

#include "generate/mesh.hpp"

namespace glint::scenes {

inline constexpr double gear_module = 0.1; ///< pitch diameter / teeth; gears that mesh share it

/// What sets one gear apart from another; lengths in the scene's units.
struct Gear {
    uint32_t teeth;     ///< at least 14, or flanks would be undercut
    double thickness;   ///< of the rim; the web is thinner, the hub thicker
    double bore_radius; ///< of the hole for the axle
    uint32_t windows;   ///< openings between spokes; 0 = a solid web
};

/// Radius of the circle on which gears roll: the middles of two that mesh are the sum of theirs apart.
[[nodiscard]] double pitch_radius(uint32_t teeth);

/// The gear's outline, counter-clockwise, with the middle of a tooth on the positive x axis; the same number of points
/// for each tooth.
[[nodiscard]] std::vector<Vec2> gear_outline(uint32_t teeth);

/// By how many turns to rotate a gear that stands in `direction` (turns) from another, rotated by `other_phase`, so
/// that they mesh.
[[nodiscard]] double meshing_phase(uint32_t teeth, double direction, uint32_t other_teeth, double other_phase);

/// The gear lying about the origin, its axis vertical, the middle of a tooth on the positive x axis.
[[nodiscard]] Mesh gear_mesh(const Gear &gear);

} // namespace glint::scenes
