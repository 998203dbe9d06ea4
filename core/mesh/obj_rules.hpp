// What holds for every OBJ file, whether its shape alone is wanted or its materials too.
#pragma once

#include <cmath>
#include <cstdint>

#include <glint/scene.hpp>

#include "mesh/obj_check.hpp"

namespace glint {

/// Reports what a mesh may not be: too large for the limits or for 32-bit indices, or without a face.
void check_counts(const ObjCounts &counts, const SceneLimits &limits, Problems &problems);

/// Whether a coordinate of a position, normal or texture coordinate is one that check_obj() lets pass.
[[nodiscard]] inline bool is_place(const glm::vec3 &p) {
    return std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate && std::abs(p.z) <= max_coordinate;
}

/// Reports that tinyobjloader understood the text otherwise than check_obj() did. It never should; a library that
/// changes its mind must not be able to put a wild index into a scene.
void tell_of_other_reading(Problems &problems);

/// Reports triangles that no ray can hit: here rather than in the scene builder, because only here is it known whose
/// they are. It is an error when there are no others.
void tell_of_triangles_without_area(uint64_t left_out, uint64_t all, Problems &problems);

} // namespace glint
