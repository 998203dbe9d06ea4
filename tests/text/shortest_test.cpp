// Numbers as text: as std::to_chars writes them.
#include "text/shortest.hpp"

#include <charconv>
#include <cmath>

#include <gtest/gtest.h>

#include "math/bits.hpp"
#include "support/random.hpp"

namespace glint::test {
namespace {

std::string as_the_standard_has_it(float value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

TEST(Shortest, is_what_the_standard_library_writes) {
    for (const float value : {0.0f, -0.0f, 1.0f, 0.1f, 100.0f, 1e5f, 1e6f, 123456.0f, 1e-4f, 1e-5f, 16777216.0f,
                              3.4e38f, 1e-45f, -0.3f, 1.0f / 3.0f}) {
        EXPECT_EQ(shortest(value), as_the_standard_has_it(value));
    }
}

TEST(Shortest, is_what_the_standard_library_writes_of_any_number) {
    Random random(1);
    int same = 0, other = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto value = bit_cast<float>(random.next());
        if (!std::isfinite(value)) continue;
        const std::string text = shortest(value), expected = as_the_standard_has_it(value);
        float back = 0.0f;
        ASSERT_EQ(std::from_chars(text.data(), text.data() + text.size(), back).ec, std::errc()) << text;
        EXPECT_EQ(back, value) << text;
        EXPECT_EQ(text.size(), expected.size()) << text << ' ' << expected;
        ++(text == expected ? same : other);
    }
    EXPECT_GT(same, 19'000);
    EXPECT_LT(other, 100) << "as short, but with other digits";
}

} // namespace
} // namespace glint::test
