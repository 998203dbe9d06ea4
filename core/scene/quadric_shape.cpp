// What kind of surface a quadric's ten coefficients make: whether there is one, and where it lies.
#include "scene/quadric_shape.hpp"

#include <cmath>
#include <limits>

#include <glm/vec3.hpp>

namespace glint {

namespace {

/// Eigenvalues this much smaller than the largest one come from the rounding of coefficients to float.
constexpr double negligible = 1e-7;

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

/// Eigenvalues and eigenvectors of a symmetric matrix by Jacobi's rotations (Golub & Van Loan, "Matrix Computations",
/// section 8.5): m becomes diagonal, and the columns of v the axes.
void diagonalise(double m[3][3], double v[3][3]) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) v[i][j] = i == j ? 1.0 : 0.0;
    }
    constexpr int sweeps = 12; // it converges quadratically; three or four do
    constexpr int pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (const auto &[p, q] : pairs) {
            if (m[p][q] == 0.0) continue;
            const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
            const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
            for (int k = 0; k < 3; ++k) {
                const double kp = m[k][p], kq = m[k][q];
                m[k][p] = c * kp - s * kq;
                m[k][q] = s * kp + c * kq;
            }
            for (int k = 0; k < 3; ++k) {
                const double pk = m[p][k], qk = m[q][k];
                m[p][k] = c * pk - s * qk;
                m[q][k] = s * pk + c * qk;
            }
            for (int k = 0; k < 3; ++k) {
                const double kp = v[k][p], kq = v[k][q];
                v[k][p] = c * kp - s * kq;
                v[k][q] = s * kp + c * kq;
            }
        }
    }
}

PrincipalForm principal_form(const Quadric &q) {
    double m[3][3] = {{q.a, q.d, q.f}, {q.d, q.b, q.e}, {q.f, q.e, q.c}};
    PrincipalForm form{};
    diagonalise(m, form.axis);
    const double g[3] = {q.g, q.h, q.j};
    const double largest = std::fmax(std::abs(m[0][0]), std::fmax(std::abs(m[1][1]), std::abs(m[2][2])));
    form.rest = q.k;
    // A quadric is what its coefficients say. That they may have been rounded to get into floats is thought of for the
    // last one alone, which is where a point, a line or a plane that stands twice shows first.
    form.rounding = 0x1p-24 * std::abs(form.rest);
    for (int i = 0; i < 3; ++i) {
        const double along = form.axis[0][i] * g[0] + form.axis[1][i] * g[1] + form.axis[2][i] * g[2];
        form.along[i] = along;
        if (std::abs(m[i][i]) > negligible * largest) {
            form.value[i] = m[i][i];
            form.rest -= along * along / m[i][i];
            form.rounding += 1e-13 * std::abs(along * along / m[i][i]); // of this arithmetic
        } else {
            const double longest = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
            form.slope[i] = std::abs(along) > negligible * longest ? along : 0.0;
        }
    }
    return form;
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
