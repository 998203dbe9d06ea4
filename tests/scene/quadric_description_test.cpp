// What a quadric is called, and its measures, against those it was made from.
#include <glint/quadric.hpp>

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace glint::test {
namespace {

/// A quadric, and what it is.
struct Case {
    Quadric quadric;
    std::string name;
    std::optional<Point> centre = {};
    std::optional<Vector> axis = {};
    std::vector<float> radii = {};
    std::optional<float> half_angle_degrees = {};
};

std::ostream &operator<<(std::ostream &out, const Case &one) {
    return out << one.name;
}

void expect_near(const std::optional<glm::vec3> &is, const std::optional<glm::vec3> &should, const char *what) {
    ASSERT_EQ(is.has_value(), should.has_value()) << what;
    if (!is) return;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR((*is)[i], (*should)[i], 2e-5f) << what << ' ' << i;
}

void expect_described(const Quadric &quadric, const Case &expected) {
    const QuadricDescription description = describe_quadric(quadric);
    EXPECT_EQ(description.name, expected.name);
    expect_near(description.centre, expected.centre, "centre");
    expect_near(description.axis, expected.axis, "axis");
    ASSERT_EQ(description.radii.size(), expected.radii.size());
    for (size_t i = 0; i < expected.radii.size(); ++i) EXPECT_NEAR(description.radii[i], expected.radii[i], 2e-5f);
    ASSERT_EQ(description.half_angle_degrees.has_value(), expected.half_angle_degrees.has_value());
    if (expected.half_angle_degrees) {
        EXPECT_NEAR(*description.half_angle_degrees, *expected.half_angle_degrees, 1e-4f);
    }
}

class QuadricDescriptions : public testing::TestWithParam<Case> {};

TEST_P(QuadricDescriptions, name_the_shape_and_measure_it) {
    const Quadric &q = GetParam().quadric;
    expect_described(q, GetParam());
    for (const float scale : {-1.0f, 1024.0f, -0x1p-9f}) { // the same points
        SCOPED_TRACE(scale);
        expect_described({q.a * scale, q.b * scale, q.c * scale, q.d * scale, q.e * scale, q.f * scale, q.g * scale,
                          q.h * scale, q.j * scale, q.k * scale},
                         GetParam());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, QuadricDescriptions,
    testing::Values(
        Case{{.a = 1, .b = 1, .c = 1, .k = -4}, "sphere", Point(0), {}, {2}},
        Case{{.a = 1, .b = 1, .c = 1, .g = -1, .j = 22, .k = 484}, "sphere", Point(1, 0, -22), {}, {1}},
        Case{{.a = 1, .b = 4, .c = 0.25f, .h = -4, .k = 3}, "ellipsoid", Point(0, 1, 0), {}, {2, 1, 0.5f}},
        // Turned around z by 45 degrees: (x + y)^2 / 2 + 4 (x - y)^2 / 2 + 4 z^2 = 4.
        Case{{.a = 2.5f, .b = 2.5f, .c = 4, .d = -1.5f, .k = -4}, "ellipsoid", Point(0), {}, {2, 1, 1}},
        Case{{.a = 1, .c = 1, .g = -3, .k = 5}, "cylinder", Point(3, 0, 0), Vector(0, 1, 0), {2}},
        Case{{.b = 1, .c = 4, .k = -4}, "elliptic cylinder", Point(0), Vector(1, 0, 0), {2, 1}},
        Case{{.a = 1, .b = -1, .k = -1}, "hyperbolic cylinder", Point(0), Vector(0, 0, 1)},
        Case{{.a = 1, .j = -1}, "parabolic cylinder"},
        Case{{.a = 1, .b = -1, .c = 1, .h = 2, .k = -4}, "cone", Point(0, 2, 0), Vector(0, 1, 0), {}, 45.0f},
        Case{{.a = 3, .b = 3, .c = -1}, "cone", Point(0), Vector(0, 0, 1), {}, 30.0f},
        Case{{.a = 1, .b = 2, .c = -1}, "elliptic cone", Point(0), Vector(0, 0, 1)},
        // y = x^2 + z^2 + 3, and the other way round.
        Case{{.a = 1, .c = 1, .h = -0.5f, .k = 3}, "paraboloid", Point(0, 3, 0), Vector(0, 1, 0)},
        Case{{.a = 1, .c = 1, .h = 0.5f, .k = -3}, "paraboloid", Point(0, 3, 0), Vector(0, -1, 0)},
        Case{{.a = 1, .c = 2, .h = -0.5f}, "elliptic paraboloid", Point(0), Vector(0, 1, 0)},
        Case{{.a = 1, .c = -2, .h = -0.5f}, "hyperbolic paraboloid", Point(0), Vector(0, 1, 0)},
        Case{{.a = 1, .b = -1, .c = 1, .k = -4}, "hyperboloid of one sheet", Point(0), Vector(0, 1, 0), {2}},
        Case{{.a = 1, .b = -1, .c = 4, .k = -4}, "hyperboloid of one sheet", Point(0), Vector(0, 1, 0), {2, 1}},
        Case{{.a = 1, .b = -1, .c = 1, .k = 4}, "hyperboloid of two sheets", Point(0), Vector(0, 1, 0)},
        Case{{.h = 0.5f, .k = 2}, "plane", Point(0, -2, 0), Vector(0, 1, 0)},
        Case{{.g = 3, .j = 4, .k = -50}, "plane", Point(3, 0, 4), Vector(0.6f, 0, 0.8f)},
        Case{{.c = 1, .j = -2, .k = 3}, "pair of parallel planes", Point(0, 0, 2), Vector(0, 0, 1)},
        Case{{.a = 1, .b = -1}, "pair of crossing planes", Point(0)}));

} // namespace
} // namespace glint::test
