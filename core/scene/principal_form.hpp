// A quadric, turned and moved to where its equation is simplest.
#pragma once

#include <glint/scene.hpp>

namespace glint {

/// The quadric in axes along which its quadratic part is a sum of squares, seen from where its linear part vanishes as
/// far as it can: sum of value[i] x_i^2 + 2 slope[i] x_i + rest = 0.
struct PrincipalForm {
    double value[3]; ///< eigenvalues; negligible ones are 0
    double slope[3]; ///< 0 wherever value is not
    double rest;
    double rounding;   ///< |rest| below this may be rounding alone
    double axis[3][3]; ///< columns: the axes, of unit length
    double along[3];   ///< the linear part along each
};

[[nodiscard]] PrincipalForm principal_form(const Quadric &quadric);

} // namespace glint
