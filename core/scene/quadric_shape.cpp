// What kind of surface a quadric's ten coefficients make: whether there is one, and where it lies.
#include "scene/quadric_shape.hpp"

#include <cmath>
#include <limits>

#include <glm/vec3.hpp>

#include "scene/principal_form.hpp"

namespace glint {

namespace {

/// Eigenvalues this much smaller than the largest one come from the rounding of coefficients to float.
constexpr double negligible = 1e-7;

/// Determinant and inverse of the quadratic part, where its leading minors say that it is definite.
struct Definite {
    double inverse[3][3];
};
std::optional<Definite> definite_part(const Quadric &q) {
    const double sign = double(q.a) + q.b + q.c < 0.0 ? -1.0 : 1.0;
    const double a = sign * q.a, b = sign * q.b, c = sign * q.c, d = sign * q.d, e = sign * q.e, f = sign * q.f;
    const double determinant = a * (b * c - e * e) - d * (d * c - e * f) + f * (d * e - b * f);
    const double scale = std::fmax(a, std::fmax(b, c));
    const double least = negligible * scale;
    if (!(a > least && b > least && c > least && a * b - d * d > least * scale &&
          determinant > least * scale * scale)) {
        return std::nullopt;
    }
    const double by = sign / determinant;
    return Definite{{{(b * c - e * e) * by, (f * e - d * c) * by, (d * e - f * b) * by},
                     {(f * e - d * c) * by, (a * c - f * f) * by, (d * f - a * e) * by},
                     {(d * e - f * b) * by, (d * f - a * e) * by, (a * b - d * d) * by}}};
}

} // namespace

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
    const std::optional<Definite> part = definite_part(q);
    if (!part) return shape;

    // (x - centre)' A (x - centre) = size, hence reach_i^2 = size (A^-1)_ii.
    const double g[3] = {q.g, q.h, q.j};
    double centre[3];
    double size = -double(q.k);
    for (int i = 0; i < 3; ++i) {
        centre[i] = -(part->inverse[i][0] * g[0] + part->inverse[i][1] * g[1] + part->inverse[i][2] * g[2]);
        size -= g[i] * centre[i];
    }
    Box bounds;
    for (int i = 0; i < 3; ++i) {
        const double reach = std::sqrt(size * part->inverse[i][i]);
        const double room = 1e-5 * reach + 1e-6 * std::abs(centre[i]);
        bounds.lo[i] = static_cast<float>(centre[i] - reach - room);
        bounds.hi[i] = static_cast<float>(centre[i] + reach + room);
        if (!(std::abs(bounds.lo[i]) <= max_coordinate && std::abs(bounds.hi[i]) <= max_coordinate)) return shape;
    }
    shape.is_bounded = true;
    shape.centre = Point(float(centre[0]), float(centre[1]), float(centre[2]));
    shape.bounds = bounds;
    return shape;
}

} // namespace glint
