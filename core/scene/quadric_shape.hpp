// What kind of surface a quadric's ten coefficients make: whether there is one, and where it lies.
#pragma once

#include <optional>
#include <string>

#include <glint/scene.hpp>

#include "math/box.hpp"

namespace glint {

/// Of a quadric that quadric_problem() has nothing against.
struct QuadricShape {
    bool is_bounded = false; ///< an ellipsoid
    Point centre{0.0f};      ///< of an ellipsoid
    /// Holds the whole ellipsoid, with room for rounding to spare; everything for the other shapes.
    Box bounds;
};

/// What is wrong with the quadric, or nothing: coefficients that are no finite numbers, that leave no surface or one
/// without area (a point, a line), or that describe a plane twice.
[[nodiscard]] std::optional<std::string> quadric_problem(const Quadric &quadric);

[[nodiscard]] QuadricShape quadric_shape(const Quadric &quadric);

} // namespace glint
