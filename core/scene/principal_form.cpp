// A quadric, turned and moved to where its equation is simplest.
#include "scene/principal_form.hpp"

#include <cmath>

namespace glint {

namespace {

/// Eigenvalues this much smaller than the largest one come from the rounding of coefficients to float.
constexpr double negligible = 1e-7;

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

} // namespace

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

} // namespace glint
