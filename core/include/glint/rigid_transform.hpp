// Where a moving object stands: a rotation and a translation, nothing that changes its size or shape.
#pragma once

#include <glm/vec3.hpp>

#include <glint/export.hpp>

namespace glint {

/// From an object's own coordinates, those of its mesh, to the world's: p -> x p.x + y p.y + z p.z + translation. The
/// axes are the columns of a rotation's matrix. The default leaves everything where it is.
struct GLINT_API RigidTransform {
    glm::vec3 x{1.0f, 0.0f, 0.0f}; ///< where the object's x axis points in the world; unit length
    glm::vec3 y{0.0f, 1.0f, 0.0f}; ///< its y axis; at right angles to x
    glm::vec3 z{0.0f, 0.0f, 1.0f}; ///< its z axis: the cross product of x and y
    glm::vec3 translation{0.0f};   ///< where the object's origin stands, in the scene's units

    /// A turn by `angle_rad` about an axis through `pivot`, counter-clockwise as seen from the axis' tip, and a move
    /// after it. The axis has any length but 0.
    [[nodiscard]] static RigidTransform turned(const glm::vec3 &axis, double angle_rad, const glm::vec3 &pivot = {},
                                               const glm::vec3 &moved_by = {});

    friend bool operator==(const RigidTransform &, const RigidTransform &) = default;
};

} // namespace glint
