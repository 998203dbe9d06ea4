// What the ten coefficients of a quadric describe, for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glint/export.hpp>
#include <glint/scene.hpp>

namespace glint {

/// A quadric in words and measures.
struct QuadricDescription {
    /// "sphere", "ellipsoid", "cylinder", "elliptic cylinder", "hyperbolic cylinder", "parabolic cylinder", "cone",
    /// "elliptic cone", "paraboloid", "elliptic paraboloid", "hyperbolic paraboloid", "hyperboloid of one sheet",
    /// "hyperboloid of two sheets", "plane", "pair of parallel planes" or "pair of crossing planes". A cylinder, cone
    /// or paraboloid without a word before it is circular.
    std::string name;
    /// The point it is symmetric about or, of a cone or paraboloid, its tip. Where there are many, as on a cylinder's
    /// axis or a plane, the one nearest to the origin. A parabolic cylinder has none.
    std::optional<Point> centre;
    /// A unit vector along a cylinder's, cone's, paraboloid's or hyperboloid's axis or across planes that do not cross;
    /// a paraboloid opens where it points. Otherwise nothing.
    std::optional<Vector> axis;
    /// Half the lengths of an ellipsoid's axes or of a cylinder's, or of the waist of a hyperboloid of one sheet; a
    /// single one where they are equal: the radius. Empty for all other shapes.
    std::vector<float> radii;
    /// Of a circular cone: the angle between its axis and its surface, in degrees.
    std::optional<float> half_angle_degrees;
};

/// Describes a quadric that a Scene may have.
[[nodiscard]] GLINT_API QuadricDescription describe_quadric(const Quadric &quadric);

} // namespace glint
