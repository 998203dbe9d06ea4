// What kind of surface ten coefficients make.
#include "scene/quadric_shape.hpp"

#include <cmath>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace glint::test {
namespace {

/// The quadric turned by angles that leave no axis where it was, then moved; computed in double, rounded once.
Quadric placed(const Quadric &q, const glm::dvec3 &by, bool turned = true) {
    double m[3][3] = {{q.a, q.d, q.f}, {q.d, q.b, q.e}, {q.f, q.e, q.c}};
    double g[3] = {q.g, q.h, q.j};
    const double s = turned ? std::sin(0.7) : 0.0, c = turned ? std::cos(0.7) : 1.0;
    const int pairs[3][2] = {{0, 1}, {1, 2}, {0, 2}};
    for (const auto &[p, r] : pairs) {
        for (int k = 0; k < 3; ++k) {
            const double x = m[k][p], y = m[k][r];
            m[k][p] = c * x - s * y;
            m[k][r] = s * x + c * y;
        }
        for (int k = 0; k < 3; ++k) {
            const double x = m[p][k], y = m[r][k];
            m[p][k] = c * x - s * y;
            m[r][k] = s * x + c * y;
        }
        const double x = g[p], y = g[r];
        g[p] = c * x - s * y;
        g[r] = s * x + c * y;
    }
    double k = q.k, moved[3];
    for (int i = 0; i < 3; ++i) {
        moved[i] = g[i];
        k -= 2.0 * g[i] * by[i];
        for (int j = 0; j < 3; ++j) {
            moved[i] -= m[i][j] * by[j];
            k += m[i][j] * by[i] * by[j];
        }
    }
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(m[0][0]), f(m[1][1]),  f(m[2][2]),  f(m[0][1]),  f(m[1][2]),
            f(m[0][2]), f(moved[0]), f(moved[1]), f(moved[2]), f(k)};
}

constexpr Quadric sphere = {1, 1, 1, 0, 0, 0, 0, 0, 0, -4}; // of radius 2

struct Named {
    std::string name;
    Quadric quadric;
    friend void PrintTo(const Named &one, std::ostream *out) { *out << one.name; }
};
const auto name_of = [](const auto &test) { return test.param.name; };

class Endless : public testing::TestWithParam<Named> {};

TEST_P(Endless, is_a_surface_without_bounds_wherever_it_lies) {
    const Quadric &q = GetParam().quadric;
    for (const Quadric &one : {q, placed(q, {0, 0, 0}), placed(q, {3, -5, 7}, false), placed(q, {3, -5, 7})}) {
        EXPECT_EQ(quadric_problem(one), std::nullopt);
        const QuadricShape shape = quadric_shape(one);
        EXPECT_FALSE(shape.is_bounded);
        EXPECT_EQ(shape.bounds.lo.x, -INFINITY);
        EXPECT_EQ(shape.bounds.hi.z, INFINITY);
    }
}

INSTANTIATE_TEST_SUITE_P(shapes, Endless,
                         testing::Values(Named{"cylinder", {1, 1, 0, 0, 0, 0, 0, 0, 0, -4}},
                                         Named{"elliptic_cylinder", {1, 4, 0, 0, 0, 0, 0, 0, 0, -4}},
                                         Named{"parabolic_cylinder", {1, 0, 0, 0, 0, 0, 0, -2, 0, 0}},
                                         Named{"hyperbolic_cylinder", {1, -1, 0, 0, 0, 0, 0, 0, 0, -4}},
                                         Named{"cone", {1, 1, -1, 0, 0, 0, 0, 0, 0, 0}},
                                         Named{"paraboloid", {1, 1, 0, 0, 0, 0, 0, 0, -2, 0}},
                                         Named{"saddle", {1, -1, 0, 0, 0, 0, 0, 0, -2, 0}},
                                         Named{"hyperboloid_of_one_sheet", {1, 1, -1, 0, 0, 0, 0, 0, 0, -4}},
                                         Named{"hyperboloid_of_two_sheets", {1, 1, -1, 0, 0, 0, 0, 0, 0, 4}},
                                         Named{"plane", {0, 0, 0, 0, 0, 0, 0, 1, 0, 4}},
                                         Named{"parallel_planes", {0, 1, 0, 0, 0, 0, 0, 0, 0, -4}},
                                         Named{"crossing_planes", {1, -1, 0, 0, 0, 0, 0, 0, 0, 0}},
                                         Named{"saddle_of_mixed_terms", {0, 0, 0, 1, 0, 0, 0, 0, 1, 0}},
                                         Named{"inside_out_cylinder", {-1, -1, 0, 0, 0, 0, 0, 0, 0, 4}}),
                         name_of);

struct Degenerate {
    std::string name;
    Quadric quadric;
    std::string message;
    friend void PrintTo(const Degenerate &one, std::ostream *out) { *out << one.name; }
};

class DegenerateQuadric : public testing::TestWithParam<Degenerate> {};

TEST_P(DegenerateQuadric, is_refused_with_words_that_say_what_it_is) {
    EXPECT_EQ(quadric_problem(GetParam().quadric), GetParam().message);
}

const std::string point = "the quadric is only a point", line = "the quadric is only a line";
const std::string twice = "the quadric is one plane, twice; write it as 2 g x + 2 h y + 2 j z + k";
const std::string nowhere = "no point of space lies on the quadric: its left side is never 0";
const std::string constant = "the quadric has no x, y or z in it: all coefficients before the last are 0";
const std::string far = "a coefficient of the quadric is not within 1e12 of 0";

INSTANTIATE_TEST_SUITE_P(
    quadrics, DegenerateQuadric,
    testing::Values(Degenerate{"zero", {}, constant}, Degenerate{"constant", {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, constant},
                    Degenerate{"negative_zeros", {-0.0f, 0, -0.0f, 0, 0, 0, 0, 0, 0, 1}, constant},
                    Degenerate{"imaginary_sphere", {1, 1, 1, 0, 0, 0, 0, 0, 0, 4}, nowhere},
                    Degenerate{"imaginary_inside_out", {-1, -1, -1, 0, 0, 0, 0, 0, 0, -4}, nowhere},
                    Degenerate{"imaginary_ellipsoid", {1, 2, 3, 0, 0, 0, 1, 1, 1, 9}, nowhere},
                    Degenerate{"imaginary_cylinder", {1, 1, 0, 0, 0, 0, 0, 0, 0, 4}, nowhere},
                    Degenerate{"imaginary_planes", {1, 0, 0, 0, 0, 0, 0, 0, 0, 4}, nowhere},
                    Degenerate{"point", {1, 1, 1, 0, 0, 0, 0, 0, 0, 0}, point},
                    Degenerate{"point_elsewhere", {1, 1, 1, 0, 0, 0, -3, -5, 7, 83}, point},
                    Degenerate{"point_of_an_ellipsoid", {4, 1, 9, 0, 0, 0, -4, 0, 0, 4}, point},
                    Degenerate{"line", {1, 1, 0, 0, 0, 0, 0, 0, 0, 0}, line},
                    Degenerate{"line_elsewhere", {1, 0, 1, 0, 0, 0, -3, 0, 7, 58}, line},
                    Degenerate{"double_plane", {0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, twice},
                    Degenerate{"double_plane_elsewhere", {1, 1, 0, 1, 0, 0, -2, -2, 0, 4}, twice},
                    Degenerate{"nan", {1, 1, 1, NAN, 0, 0, 0, 0, 0, -1}, far},
                    Degenerate{"infinite", {1, 1, 1, 0, 0, 0, 0, 0, 0, -INFINITY}, far},
                    Degenerate{"far", {1, 1, 1, 0, 0, 0, 0, 2e12f, 0, -1}, far}),
    name_of);

TEST(Ellipsoids, are_bounded_and_have_a_centre) {
    const QuadricShape shape = quadric_shape(sphere);
    ASSERT_TRUE(shape.is_bounded);
    EXPECT_EQ(shape.centre, Point(0, 0, 0));
    for (int i = 0; i < 3; ++i) {
        EXPECT_LT(shape.bounds.lo[i], -2.0f);
        EXPECT_GT(shape.bounds.hi[i], 2.0f);
        EXPECT_NEAR(shape.bounds.hi[i], 2.0f, 1e-4f);
    }
    const QuadricShape other = quadric_shape({-1, -1, -1, 0, 0, 0, 3, -5, 7, -79}); // signs reversed; radius 2
    ASSERT_TRUE(other.is_bounded);
    EXPECT_EQ(other.centre, Point(3, -5, 7));
}

TEST(Ellipsoids, may_be_as_small_as_their_distance_lets_their_coefficients_say) {
    // Whole numbers below 2^24 are exact: (x - 4000)^2 + y^2 + z^2 = 1.
    const Quadric distant = {1, 1, 1, 0, 0, 0, -4000, 0, 0, 15999999};
    EXPECT_EQ(quadric_problem(distant), std::nullopt);
    const QuadricShape shape = quadric_shape(distant);
    ASSERT_TRUE(shape.is_bounded);
    EXPECT_EQ(shape.centre, Point(4000, 0, 0));
    EXPECT_NEAR(shape.bounds.hi.y, 1.0f, 0.01f);
    for (const double distance : {10.0, 100.0, 1000.0}) {
        const Quadric moved = placed(sphere, {distance, -distance, distance}, false);
        EXPECT_EQ(quadric_problem(moved), std::nullopt) << distance;
        EXPECT_TRUE(quadric_shape(moved).is_bounded) << distance;
    }
}

TEST(Ellipsoids, may_be_flat_or_long) {
    for (const float squeeze : {1e-5f, 1e-4f, 0.01f, 100.0f, 1e4f, 1e5f}) {
        for (const bool turned : {false, true}) {
            const Quadric thin = placed({1, 1, squeeze, 0, 0, 0, 0, 0, 0, -1}, {1, 2, 3}, turned);
            EXPECT_EQ(quadric_problem(thin), std::nullopt) << squeeze;
            EXPECT_TRUE(quadric_shape(thin).is_bounded) << squeeze << ' ' << turned;
        }
    }
}

TEST(Ellipsoids, lie_inside_their_bounds_and_touch_them) {
    Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 size = random.in_box(glm::vec3(0.8f), glm::vec3(2.0f));
        const glm::vec3 place = random.in_box(glm::vec3(-10.0f), glm::vec3(10.0f));
        const auto inverse_square = [](float x) { return 1.0f / (x * x); };
        const Quadric straight = {
            inverse_square(size.x), inverse_square(size.y), inverse_square(size.z), 0, 0, 0, 0, 0, 0, -1};
        const Quadric q = placed(straight, glm::dvec3(place));
        ASSERT_EQ(quadric_problem(q), std::nullopt);
        const QuadricShape shape = quadric_shape(q);
        ASSERT_TRUE(shape.is_bounded);
        // Where the surface is crossed on a line from the centre; in double, of the float coefficients.
        const auto value = [&](const glm::dvec3 &p) {
            return q.a * p.x * p.x + q.b * p.y * p.y + q.c * p.z * p.z +
                   2.0 * (q.d * p.x * p.y + q.e * p.y * p.z + q.f * p.x * p.z + q.g * p.x + q.h * p.y + q.j * p.z) +
                   q.k;
        };
        const glm::dvec3 centre(shape.centre);
        glm::dvec3 low = centre, high = centre;
        for (int k = 0; k < 200; ++k) {
            const glm::dvec3 towards(random.direction());
            double inside = 0.0, outside = 10.0;
            ASSERT_LT(value(centre), 0.0);
            ASSERT_GT(value(centre + towards * outside), 0.0);
            for (int halving = 0; halving < 50; ++halving) {
                const double middle = 0.5 * (inside + outside);
                (value(centre + towards * middle) < 0.0 ? inside : outside) = middle;
            }
            const glm::dvec3 p = centre + towards * inside;
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_GE(p[axis], shape.bounds.lo[axis]);
                ASSERT_LE(p[axis], shape.bounds.hi[axis]);
                low[axis] = std::fmin(low[axis], p[axis]);
                high[axis] = std::fmax(high[axis], p[axis]);
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            const double width = shape.bounds.hi[axis] - shape.bounds.lo[axis];
            EXPECT_LT(width, 1.5 * (high[axis] - low[axis])) << "far too much room";
        }
    }
}

TEST(Ellipsoids, that_reach_beyond_the_largest_coordinate_count_as_endless) {
    const Quadric vast = {1e-11f, 1e-11f, 1e-11f, 0, 0, 0, 0, 0, 0, -1e12f};
    EXPECT_EQ(quadric_problem(vast), std::nullopt);
    EXPECT_TRUE(quadric_shape(vast).is_bounded) << "sqrt(1e23) is 3e11";
    const Quadric too_vast = {1e-13f, 1e-13f, 1e-13f, 0, 0, 0, 0, 0, 0, -1e12f};
    EXPECT_FALSE(quadric_shape(too_vast).is_bounded);
}

} // namespace
} // namespace glint::test
