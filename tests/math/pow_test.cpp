// pow_unit against the C library in double.
#include <cfloat>
#include <cmath>

#include <gtest/gtest.h>

#include "math/pow.hpp"
#include "support/random.hpp"

namespace glint::test {
namespace {

/// The relative error as a share of the stated bound.
double share_of_bound(float x, float y) {
    const double truth = std::pow(double(x), double(y));
    const double bound = 0x1p-21 + 0x1p-23 * std::fabs(double(y) * std::log2(double(x)));
    return std::fabs(double(pow_unit(x, y)) - truth) / truth / bound;
}

TEST(Pow, stays_within_its_stated_error) {
    Random random(1);
    double worst = 0.0;
    int compared = 0;
    for (int i = 0; i < 300'000; ++i) {
        const float x = i % 3 == 0 ? 1.0f - random.uniform(0.0f, 1e-3f) : random.uniform(0.0f, 1.0f);
        const float y = i % 2 == 0 ? random.uniform(0.0f, 64.0f) : std::exp(random.uniform(-5.0f, 13.8f));
        if (pow_unit(x, y) < FLT_MIN) {
            ASSERT_LT(std::pow(double(x), double(y)), FLT_MIN * 1.001);
            continue;
        }
        worst = std::max(worst, share_of_bound(x, y));
        ++compared;
    }
    EXPECT_LT(worst, 1.0);
    EXPECT_GT(worst, 0.1) << "the stated bound is far too wide";
    EXPECT_GT(compared, 100'000);
}

TEST(Pow, corners_are_exact) {
    EXPECT_EQ(pow_unit(0.0f, 0.0f), 1.0f);
    EXPECT_EQ(pow_unit(0.5f, 0.0f), 1.0f);
    EXPECT_EQ(pow_unit(0.0f, 10.0f), 0.0f);
    EXPECT_EQ(pow_unit(1.0f, 1e6f), 1.0f);
    EXPECT_EQ(pow_unit(0.25f, 0.5f), 0.5f);
    EXPECT_EQ(pow_unit(0.5f, 10.0f), 0x1p-10f);
    EXPECT_EQ(pow_unit(0.5f, 1e6f), 0.0f);
    EXPECT_EQ(pow_unit(1e-40f, 1.0f), 0.0f) << "below the smallest normal float";
}

} // namespace
} // namespace glint::test
