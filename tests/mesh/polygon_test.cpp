// Polygons lose nothing when they are cut.
#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "support/cpu_time.hpp"
#include "support/random.hpp"

namespace glint::test {
namespace {

/// Twice the signed area, seen from +z.
double doubled_area(const Point &a, const Point &b, const Point &c) {
    return (double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x);
}

double doubled_area(const std::vector<Point> &polygon) {
    double sum = 0.0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        sum += doubled_area(polygon[0], polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    return sum;
}

std::vector<Triangle> cut(const std::vector<Point> &polygon) {
    std::vector<uint32_t> corners(polygon.size());
    std::iota(corners.begin(), corners.end(), 0u);
    std::vector<Triangle> triangles(polygon.size() - 2);
    PolygonCutter().cut(corners, polygon, triangles.data());
    return triangles;
}

/// The triangles' areas have the polygon's sign and sum; each edge of the outline belongs to one triangle, each other
/// edge to two that go opposite ways.
void expect_exact_cover(const std::vector<Point> &polygon) {
    const std::vector<Triangle> triangles = cut(polygon);
    const double whole = doubled_area(polygon);
    double sum = 0.0;
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const Triangle &t : triangles) {
        const double area = doubled_area(polygon[t.a], polygon[t.b], polygon[t.c]);
        EXPECT_GT(area * whole, 0.0) << "a triangle of " << t.a << ' ' << t.b << ' ' << t.c;
        sum += area;
        for (const auto &edge : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) ++edges[edge];
    }
    EXPECT_NEAR(sum, whole, 1e-9 * std::abs(whole));
    const auto count = static_cast<uint32_t>(polygon.size());
    for (uint32_t i = 0; i < count; ++i) {
        EXPECT_EQ((edges[{i, (i + 1) % count}]), 1) << "edge from corner " << i;
        edges[{(i + 1) % count, i}] += 1; // the outside, so that every edge has its opposite
    }
    for (const auto &[edge, uses] : edges) {
        EXPECT_EQ(uses, 1) << edge.first << " to " << edge.second;
        EXPECT_EQ((edges[{edge.second, edge.first}]), 1) << edge.first << " to " << edge.second;
    }
}

std::vector<Point> reversed(std::vector<Point> polygon) {
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

constexpr double two_pi = 6.283185307179586;

Point on_circle(double turn, double radius) {
    return {static_cast<float>(radius * std::cos(two_pi * turn)), static_cast<float>(radius * std::sin(two_pi * turn)),
            0};
}

/// Around the origin with random radii: simple, with many reflex corners.
std::vector<Point> star(uint32_t corners, uint64_t seed, float least_radius) {
    Random random(seed);
    std::vector<Point> polygon;
    for (uint32_t i = 0; i < corners; ++i) {
        polygon.push_back(on_circle(double{static_cast<double>(i)} / corners, random.uniform(least_radius, 1.0f)));
    }
    return polygon;
}

/// Long thin teeth, turned so that they lie across every grid.
std::vector<Point> comb(uint32_t teeth, double turn) {
    std::vector<Point> polygon;
    const double c = std::cos(turn), s = std::sin(turn);
    const auto add = [&](double x, double y) {
        polygon.emplace_back(static_cast<float>(c * x - s * y), static_cast<float>(s * x + c * y), 0.0f);
    };
    add(teeth, -1.0);
    for (uint32_t i = teeth; i-- > 0;) {
        add(i + 0.75, 0.0);
        add(i + 0.5, teeth);
        add(i + 0.25, 0.0);
    }
    add(0.0, -1.0);
    return polygon;
}

/// A band wound round the origin: every corner of its inner side is reflex.
std::vector<Point> spiral(uint32_t steps, double windings) {
    std::vector<Point> polygon;
    for (uint32_t i = 0; i <= steps; ++i)
        polygon.push_back(on_circle(windings * i / steps, 1.0 + windings * i / steps));
    for (uint32_t i = steps + 1; i-- > 0;) {
        polygon.push_back(on_circle(windings * i / steps, 1.4 + windings * i / steps));
    }
    return polygon;
}

TEST(Polygons, that_are_concave_quadrilaterals_are_cut_inside) {
    // The shorter diagonal of this dart lies outside of it.
    const std::vector<Point> dart = {{0, 0, 0}, {1, 0.2f, 0}, {2, 0, 0}, {1, 5, 0}};
    for (size_t first = 0; first < 4; ++first) {
        std::vector<Point> turned = dart;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
        expect_exact_cover(turned);
        expect_exact_cover(reversed(turned));
    }
}

TEST(Polygons, that_are_convex_quadrilaterals_are_cut_along_the_shorter_diagonal) {
    const std::vector<Triangle> triangles = cut({{0, 0, 0}, {5, 1, 0}, {6, 6, 0}, {1, 5, 0}});
    EXPECT_EQ(triangles, (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Polygons, of_every_shape_are_covered_exactly) {
    expect_exact_cover({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}});
    expect_exact_cover({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
    for (uint32_t corners : {5u, 7u, 20u, 333u}) {
        expect_exact_cover(star(corners, corners, 1.0f));
        expect_exact_cover(star(corners, corners, 0.1f));
        expect_exact_cover(reversed(star(corners, corners, 0.1f)));
    }
    expect_exact_cover(comb(50, 0.7));
    expect_exact_cover(reversed(comb(50, 0.0)));
    expect_exact_cover(spiral(300, 5.0));
}

TEST(Polygons, keep_corners_that_lie_on_a_straight_edge) {
    expect_exact_cover({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}});
    expect_exact_cover({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {1, 3, 0}, {0, 3, 0}});
    expect_exact_cover({{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 0}, {0, 0, 0}});
}

TEST(Polygons, may_have_holes_written_as_a_cut_there_and_back) {
    // A square, and a square hole whose cut leaves corner 0 and comes back to its twin.
    const std::vector<Point> ring = {{0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0},
                                     {1, 1, 0}, {0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
    expect_exact_cover(ring);
    expect_exact_cover(reversed(ring));
}

TEST(Polygons, may_have_jagged_holes_cut_anywhere) {
    Random random(11);
    for (int i = 0; i < 300; ++i) {
        const uint32_t corners = 3 + random.below(20), bridge = random.below(corners);
        std::vector<Point> outline, hole;
        for (uint32_t k = 0; k < corners; ++k) {
            const double turn = static_cast<double>(k + bridge) / corners;
            outline.push_back(on_circle(turn, corners == 3 ? 3.0 : random.uniform(2.0f, 3.0f)));
            hole.push_back(on_circle(turn, random.uniform(0.3f, 1.0f)));
        }
        // Once around the outline, over to the hole, once around it the other way, and back.
        std::vector<Point> polygon = outline;
        polygon.push_back(outline[0]);
        polygon.push_back(hole[0]);
        polygon.insert(polygon.end(), hole.rbegin(), hole.rend());
        const uint32_t first = random.below(static_cast<uint32_t>(polygon.size()));
        std::rotate(polygon.begin(), polygon.begin() + first, polygon.end());
        expect_exact_cover(i % 2 == 0 ? polygon : reversed(polygon));
        if (HasFailure()) FAIL() << "polygon " << i << " of " << corners << " corners a ring";
    }
}

TEST(Polygons, may_have_a_string_of_holes) {
    for (int holes = 1; holes <= 20; ++holes) {
        const auto width = static_cast<float>(3 * holes);
        std::vector<Point> polygon = {{0, 0, 0}, {0, -3, 0}, {width, -3, 0}, {width, 3, 0}, {0, 3, 0}, {0, 0, 0}};
        // Diamonds from left to right over their upper corners, and back over their lower ones.
        for (int i = 0; i < holes; ++i) {
            const auto left = static_cast<float>(3 * i + 1);
            polygon.insert(polygon.end(), {{left, 0, 0}, {left + 0.5f, 1, 0}, {left + 1, 0, 0}});
        }
        for (int i = holes; i-- > 0;) {
            const auto left = static_cast<float>(3 * i + 1);
            if (i + 1 < holes) polygon.emplace_back(left + 1, 0.0f, 0.0f);
            polygon.insert(polygon.end(), {{left + 0.5f, -1, 0}, {left, 0, 0}});
        }
        expect_exact_cover(polygon);
        expect_exact_cover(reversed(polygon));
        if (HasFailure()) FAIL() << holes << " holes";
    }
}

TEST(Polygons, that_touch_themselves_keep_their_area) {
    // Two triangles, tip to tip; the two triangles that the tips cost have no area.
    const std::vector<Point> hourglass = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {0, 0, 0}, {-2, 1, 0}, {-2, -1, 0}};
    for (const auto &polygon : {hourglass, reversed(hourglass)}) {
        double sum = 0.0;
        for (const Triangle &t : cut(polygon)) sum += std::abs(doubled_area(polygon[t.a], polygon[t.b], polygon[t.c]));
        EXPECT_EQ(sum, std::abs(doubled_area(polygon)));
    }
}

TEST(Polygons, in_space_keep_their_winding_and_area) {
    Random random(5);
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 u = random.direction(), other = random.direction();
        const glm::vec3 v =
            glm::vec3(u.y * other.z - u.z * other.y, u.z * other.x - u.x * other.z, u.x * other.y - u.y * other.x);
        const std::vector<Point> flat = star(40, 100 + static_cast<uint64_t>(i), 0.2f);
        std::vector<Point> polygon;
        for (const Point &p : flat) polygon.push_back(u * p.x + v * p.y + glm::vec3(3, 4, 5));
        // The plane's map sends (x, y) to u x + v y: areas grow by |u x v| = |v|, and keep their sign along u x v.
        const glm::dvec3 normal(glm::vec3(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x));
        double sum = 0.0;
        for (const Triangle &t : cut(polygon)) {
            const glm::dvec3 ab(polygon[t.b] - polygon[t.a]), ac(polygon[t.c] - polygon[t.a]);
            const double along = normal.x * (ab.y * ac.z - ab.z * ac.y) + normal.y * (ab.z * ac.x - ab.x * ac.z) +
                                 normal.z * (ab.x * ac.y - ab.y * ac.x);
            EXPECT_GT(along, -1e-5);
            sum += along;
        }
        const double square = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
        EXPECT_NEAR(sum, doubled_area(flat) * square, 1e-4 * square);
    }
}

TEST(Polygons, that_cross_themselves_or_have_no_area_still_become_triangles_of_their_corners) {
    const auto expect_corners_used = [](const std::vector<Point> &polygon) {
        std::vector<bool> used(polygon.size());
        for (const Triangle &t : cut(polygon)) {
            EXPECT_TRUE(t.a != t.b && t.b != t.c && t.c != t.a);
            for (const uint32_t corner : {t.a, t.b, t.c}) used.at(corner) = true;
        }
        EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
    };
    std::vector<Point> pentagram;
    for (int i = 0; i < 5; ++i) pentagram.push_back(on_circle(0.4 * i, 1.0));
    expect_corners_used(pentagram);
    expect_corners_used({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
    expect_corners_used({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0.5f, 0}});
    expect_corners_used({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {2, 0, 0}});
    expect_corners_used(std::vector<Point>(9, Point(1, 2, 3)));
    Random random(1);
    std::vector<Point> tangle;
    for (int i = 0; i < 1000; ++i) tangle.push_back(random.in_box(Point(-1), Point(1)));
    expect_corners_used(tangle);
}

TEST(Polygons, with_a_hundred_thousand_corners_take_no_quadratic_time) {
#ifdef GLINT_SANITIZED
    constexpr uint32_t many = 20000; // what is looked for there does not need size
#else
    constexpr uint32_t many = 100000;
#endif
    Random random(2);
    std::vector<Point> tangle;
    for (uint32_t i = 0; i < many / 10; ++i) tangle.push_back(random.in_box(Point(-1), Point(1)));
    const std::vector<std::vector<Point>> polygons = {star(many, 1, 1.0f),    star(many, 1, 0.5f),
                                                      comb(many / 3, 0.0),    comb(many / 30, 0.78),
                                                      spiral(many / 2, 50.0), tangle};
    for (size_t i = 0; i < polygons.size(); ++i) {
        const CpuTime time;
        const std::vector<Triangle> triangles = cut(polygons[i]);
        const double seconds = time.seconds();
        EXPECT_LT(seconds, 20.0) << "polygon " << i; // one second at most; minutes if quadratic
        if (i + 1 == polygons.size()) continue;
        double sum = 0.0;
        for (const Triangle &t : triangles) {
            sum += doubled_area(polygons[i][t.a], polygons[i][t.b], polygons[i][t.c]);
        }
        EXPECT_NEAR(sum, doubled_area(polygons[i]), 1e-6 * std::abs(sum)) << "polygon " << i;
        RecordProperty("milliseconds_of_polygon_" + std::to_string(i), static_cast<int>(seconds * 1000));
    }
}

} // namespace
} // namespace glint::test
