// What a smooth or textured surface is like at a point of one of its triangles.
#pragma once

#include <glm/vec3.hpp>

#include "kernel/kernel.hpp"

namespace glint {

struct SurfaceDetail {
    glm::vec3 normal; ///< for shading; unit length
    Color tint;       ///< what the texture multiplies the surface's colour by
};

/// At a point that a ray of direction `dir` has hit; `facet` is the triangle's own normal on the viewer's side. The
/// surface has details or a texture. Of one that moves, what its triangles have is looked up in the object's space.
[[nodiscard]] SurfaceDetail surface_detail(const KernelScene &scene, uint32_t surface, uint32_t triangle_id,
                                           const glm::vec3 &point, const glm::vec3 &dir, const glm::vec3 &facet);

} // namespace glint
