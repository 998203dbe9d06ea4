// The generator's building blocks against their definitions.
#include "generate/shapes.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "generate/noise.hpp"
#include "generate/trig.hpp"

namespace glint::scenes {
namespace {

TEST(Trig, agrees_with_the_mathematical_library) {
    for (int i = -10000; i <= 10000; ++i) {
        const double turns = i / 3333.0;
        const auto [cosine, sine] = cos_sin_turns(turns);
        ASSERT_NEAR(cosine, std::cos(turns * 2.0 * pi), 1e-14) << turns;
        ASSERT_NEAR(sine, std::sin(turns * 2.0 * pi), 1e-14) << turns;
    }
}

TEST(Trig, is_exact_at_quarter_turns) {
    EXPECT_EQ(cos_sin_turns(0.25).cosine, 0.0);
    EXPECT_EQ(cos_sin_turns(0.25).sine, 1.0);
    EXPECT_EQ(cos_sin_turns(-0.5).cosine, -1.0);
    EXPECT_EQ(cos_sin_turns(-0.5).sine, 0.0);
}

TEST(Noise, has_the_slope_that_it_states) {
    constexpr double step = 1e-6;
    for (int i = 0; i < 1000; ++i) {
        const Vec2 p{i * 0.37 - 150.0, i * 0.11 + 3.0};
        const NoiseSample sample = value_noise(p, 5);
        ASSERT_GE(sample.value, 0.0);
        ASSERT_LE(sample.value, 1.0);
        const double slope_x = (value_noise(p + Vec2{step, 0.0}, 5).value - sample.value) / step;
        const double slope_y = (value_noise(p + Vec2{0.0, step}, 5).value - sample.value) / step;
        ASSERT_NEAR(sample.slope.x, slope_x, 1e-4) << i;
        ASSERT_NEAR(sample.slope.y, slope_y, 1e-4) << i;
    }
}

TEST(GeodesicSphere, has_its_counts_and_radius) {
    for (const uint32_t frequency : {1u, 2u, 3u, 10u}) {
        const Mesh sphere = geodesic_sphere(frequency);
        EXPECT_EQ(sphere.triangles.size(), 20u * frequency * frequency);
        EXPECT_EQ(sphere.positions.size(), 10u * frequency * frequency + 2u);
        for (const Vec3 p : sphere.positions) ASSERT_NEAR(glm::length(p), 1.0, 1e-15);
    }
}

TEST(SmoothProfile, goes_through_its_points_and_keeps_off_the_axis) {
    const std::vector<Vec2> points{{0.0, 0.0}, {1.0, 0.0}, {0.01, 1.0}, {1.0, 2.0}, {0.0, 2.0}};
    const auto curve = smooth_profile(points, 4);
    ASSERT_EQ(curve.size(), 17u);
    for (size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(curve[i * 4].x, points[i].x, 1e-15);
        EXPECT_NEAR(curve[i * 4].y, points[i].y, 1e-15);
    }
    for (size_t i = 1; i + 1 < curve.size(); ++i) EXPECT_GT(curve[i].x, 0.0);
}

} // namespace
} // namespace glint::scenes
