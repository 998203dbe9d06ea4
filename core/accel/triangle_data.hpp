// Triangles laid out for tracing: what intersection reads, and what shading reads, each in one piece.
#pragma once

#include <cstdint>

#include <glint/scene.hpp>

#include "accel/uninitialized_vector.hpp"
#include "math/box.hpp"
#include "threads/crew.hpp"

namespace glint {

/// Corner positions, as the mesh has them. All a ray needs to know whether it hits.
struct TriangleCorners {
    glm::vec3 a, b, c;

    [[nodiscard]] Box bounds() const {
        Box box;
        box.extend(a);
        box.extend(b);
        box.extend(c);
        return box;
    }
};
static_assert(sizeof(TriangleCorners) == 36);

/// What a hit needs to know: the geometric normal (unit, the side by winding) and the surface in scene order.
struct TriangleSurface {
    glm::vec3 normal;
    uint32_t surface;
};
static_assert(sizeof(TriangleSurface) == 16);

/// Both arrays are indexed by triangle_id.
struct TriangleData {
    UninitializedVector<TriangleCorners> corners;
    UninitializedVector<TriangleSurface> surfaces; ///< those of the scene's quadrics, without normals, come last

    /// Of all triangles of the scene, made by so many threads.
    [[nodiscard]] static TriangleData from(const Scene &scene, const Crew &crew = 1);
};

} // namespace glint
