// Exact-enough area of a triangle: decides which triangles are worth keeping, and weighs a light's centroid.
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include <glint/scene.hpp>

namespace glint {

/// (b - a) x (c - a) in double precision: twice the area times the normal. Zero for a triangle without area.
[[nodiscard]] glm::dvec3 doubled_area_normal(const Mesh &mesh, const Triangle &triangle);

/// False for triangles that no ray can hit: collinear or coincident corners. Indices must be in range.
[[nodiscard]] bool has_area(const Mesh &mesh, const Triangle &triangle);

/// Takes out the triangles that have no area, and their normals' and texture coordinates' corners with them. Says how
/// many. Indices must be in range; the corners are for all triangles or for none.
size_t erase_triangles_without_area(Mesh &mesh);

/// Mean of the surface: each triangle's centroid weighted by its area. The mesh has a triangle with area.
[[nodiscard]] Point area_weighted_centroid(const Mesh &mesh);

} // namespace glint
