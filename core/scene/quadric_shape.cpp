// What kind of surface a quadric's ten coefficients make: whether there is one, and where it lies.
#include "scene/quadric_shape.hpp"

#include <cmath>
#include <limits>

#include <glm/vec3.hpp>

#include "scene/principal_form.hpp"

namespace glint {

std::optional<std::string> quadric_problem(const Quadric &q) {
    const float all[] = {q.a, q.b, q.c, q.d, q.e, q.f, q.g, q.h, q.j, q.k};
    for (const float coefficient : all) {
        if (!(std::abs(coefficient) <= max_coordinate)) return "a coefficient of the quadric is not within 1e12 of 0";
    }
    bool is_constant = true;
    for (int i = 0; i < 9; ++i) is_constant = is_constant && all[i] == 0.0f;
    if (is_constant) return "the quadric has no x, y or z in it: all coefficients before the last are 0";

    const PrincipalForm form = principal_form(q);
    int positive = 0, negative = 0;
    for (int i = 0; i < 3; ++i) {
        if (form.slope[i] != 0.0) return std::nullopt; // a plane or a paraboloid goes on for ever
        positive += form.value[i] > 0.0 ? 1 : 0;
        negative += form.value[i] < 0.0 ? 1 : 0;
    }
    if (std::abs(form.rest) <= form.rounding) {
        if (positive > 0 && negative > 0) return std::nullopt; // a cone or two planes
        if (positive + negative == 1) return "the quadric is one plane, twice; write it as 2 g x + 2 h y + 2 j z + k";
        return positive + negative == 2 ? "the quadric is only a line" : "the quadric is only a point";
    }
    if ((form.rest > 0.0 ? negative : positive) > 0) return std::nullopt;
    return "no point of space lies on the quadric: its left side is never 0";
}

QuadricShape quadric_shape(const Quadric &q) {
    constexpr float everywhere = std::numeric_limits<float>::infinity();
    QuadricShape shape;
    shape.bounds.lo = glm::vec3(-everywhere);
    shape.bounds.hi = glm::vec3(everywhere);
    const PrincipalForm form = principal_form(q);
    for (const double value : form.value) {
        if (!(value * form.rest < 0.0)) return shape; // all of one sign, the rest of the other: an ellipsoid
    }

    // Along its axes the ellipsoid reaches sqrt(-rest / value) from its centre at -along / value.
    Box bounds;
    for (int i = 0; i < 3; ++i) {
        double centre = 0.0, squared_reach = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            centre -= form.axis[i][axis] * form.along[axis] / form.value[axis];
            squared_reach -= form.axis[i][axis] * form.axis[i][axis] * form.rest / form.value[axis];
        }
        const double reach = std::sqrt(squared_reach);
        const double room = 1e-5 * reach + 1e-6 * std::abs(centre);
        shape.centre[i] = static_cast<float>(centre);
        bounds.lo[i] = static_cast<float>(centre - reach - room);
        bounds.hi[i] = static_cast<float>(centre + reach + room);
        if (!(std::abs(bounds.lo[i]) <= max_coordinate && std::abs(bounds.hi[i]) <= max_coordinate)) return shape;
    }
    shape.is_bounded = true;
    shape.bounds = bounds;
    return shape;
}

} // namespace glint
