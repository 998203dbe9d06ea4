// Closed meshes that several models are put together from.
#pragma once

#include <cstdint>
#include <vector>

#include "generate/mesh.hpp"

namespace glint::scenes {

/// The unit sphere about the origin: an icosahedron whose faces are cut into frequency^2 triangles each, pushed out to
/// the sphere. 20 * frequency^2 triangles, 10 * frequency^2 + 2 vertices; frequency >= 1.
[[nodiscard]] Mesh geodesic_sphere(uint32_t frequency);

/// An axis-parallel box, 12 triangles; low < high in each coordinate.
[[nodiscard]] Mesh box(Vec3 low, Vec3 high);

/// A body of revolution about the vertical axis. The profile is its outline from bottom to top as (radius, height)
/// points; it begins and ends on the axis (radius 0, one vertex each) and has positive radii between.
[[nodiscard]] Mesh lathe(const std::vector<Vec2> &profile, uint32_t segments);

/// A ring about the vertical axis, in the plane y = 0: a circle of radius `minor` swept along one of radius `major`.
[[nodiscard]] Mesh torus(double major, double minor, uint32_t major_segments, uint32_t minor_segments);

/// Points of a smooth curve through all of `points` (Catmull and Rom 1974), `steps` to each stretch; radii are kept
/// from falling below zero. Made for lathe profiles.
[[nodiscard]] std::vector<Vec2> smooth_profile(const std::vector<Vec2> &points, uint32_t steps);

} // namespace glint::scenes
