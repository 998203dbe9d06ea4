// pow_unit against the C library in long double.
#include <cfloat>
#include <cmath>

#include <gtest/gtest.h>

#include "math/pow.hpp"
#include "support/random.hpp"

namespace glint::test {
namespace {

/// Distance between the result and the true value, in units in the last place of the result.
double error_ulps(float x, float y) {
    const float result = pow_unit(x, y);
    const long double truth = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    const long double ulp = static_cast<long double>(std::nextafter(result, 2.0f)) - result;
    return static_cast<double>(std::fabs((static_cast<long double>(result) - truth) / ulp));
}

TEST(Pow, stays_within_its_stated_error) {
    Random random(1);
    double worst = 0.0;
    int compared = 0;
    for (int i = 0; i < 300'000; ++i) {
        const float x = i % 3 == 0 ? 1.0f - random.uniform(0.0f, 1e-3f) : random.uniform(0.0f, 1.0f);
        const float y = i % 2 == 0 ? random.uniform(0.0f, 64.0f) : std::exp(random.uniform(-5.0f, 13.8f));
        if (pow_unit(x, y) < FLT_MIN) {
            ASSERT_LT(std::pow(static_cast<long double>(x), static_cast<long double>(y)), FLT_MIN * 1.0000002L);
            continue;
        }
        worst = std::max(worst, error_ulps(x, y));
        ++compared;
    }
    EXPECT_LT(worst, 0.501);
    EXPECT_GT(compared, 100'000);
}

TEST(Pow, corners_are_exact) {
    EXPECT_EQ(pow_unit(0.0f, 0.0f), 1.0f);
    EXPECT_EQ(pow_unit(0.5f, 0.0f), 1.0f);
    EXPECT_EQ(pow_unit(0.0f, 10.0f), 0.0f);
    EXPECT_EQ(pow_unit(1.0f, 1e6f), 1.0f);
    EXPECT_EQ(pow_unit(0.25f, 0.5f), 0.5f);
    EXPECT_EQ(pow_unit(0.5f, 10.0f), 0x1p-10f);
    EXPECT_EQ(pow_unit(0.7f, 1.0f), 0.7f);
    EXPECT_EQ(pow_unit(0.5f, 1e6f), 0.0f);
    EXPECT_EQ(pow_unit(1e-40f, 1.0f), 0.0f) << "below the smallest normal float";
}

} // namespace
} // namespace glint::test
