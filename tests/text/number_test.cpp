// The strict numbers of scene files.
#include "text/number.hpp"

#include <clocale>
#include <limits>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace glint::test {
namespace {

float value_of(std::string_view token) {
    float value = std::numeric_limits<float>::quiet_NaN();
    const auto fault = read_number(token, value);
    EXPECT_FALSE(fault) << token << ": " << fault->message;
    return value;
}

TEST(Numbers, are_read_to_the_nearest_float) {
    EXPECT_EQ(value_of("0"), 0.0f);
    EXPECT_EQ(value_of("-0.0"), 0.0f);
    EXPECT_EQ(value_of("+1.5"), 1.5f);
    EXPECT_EQ(value_of("5.7"), 5.7f);
    EXPECT_EQ(value_of(".5"), 0.5f);
    EXPECT_EQ(value_of("-7."), -7.0f);
    EXPECT_EQ(value_of("1e3"), 1000.0f);
    EXPECT_EQ(value_of("25E-1"), 2.5f);
    EXPECT_EQ(value_of("1.e+2"), 100.0f);
    EXPECT_EQ(value_of("3.4028235e38"), std::numeric_limits<float>::max());
    EXPECT_EQ(value_of("0.1000000000000000055511151231257827"), 0.1f);
    EXPECT_EQ(value_of("0000000000000000000000000000000000000000000000001.25"), 1.25f);
}

TEST(Numbers, too_small_for_a_float_are_zero) {
    EXPECT_EQ(value_of("1e-46"), 0.0f);
    EXPECT_EQ(value_of("-1e-400"), 0.0f);
    EXPECT_EQ(value_of("1e-99999999999999999999"), 0.0f);
    EXPECT_EQ(value_of("0." + std::string(500, '0') + "1"), 0.0f);
    EXPECT_EQ(value_of("0e999"), 0.0f);
    EXPECT_EQ(value_of("1e-40"), 1e-40f) << "denormal, and not too small";
}

TEST(Numbers, do_not_depend_on_the_locale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char *locale : {"de_DE.UTF-8", "pt_BR.UTF-8", "de_DE", "C"}) {
        std::setlocale(LC_ALL, locale); // where it is not installed, nothing changes
        EXPECT_EQ(value_of("0.5"), 0.5f) << locale;
    }
    std::setlocale(LC_ALL, before.c_str());
}

struct BadNumber {
    const char *token;
    const char *message;
    const char *hint;
};

std::ostream &operator<<(std::ostream &out, const BadNumber &number) {
    return out << number.token;
}

class BadNumbers : public ::testing::TestWithParam<BadNumber> {};

TEST_P(BadNumbers, are_told_what_is_wrong_with_them) {
    float value = 0.0f;
    const auto fault = read_number(GetParam().token, value);
    ASSERT_TRUE(fault) << GetParam().token << " was read as " << value;
    EXPECT_EQ(fault->message, GetParam().message);
    EXPECT_EQ(fault->hint, GetParam().hint);
}

INSTANTIATE_TEST_SUITE_P(
    Of, BadNumbers,
    ::testing::Values(BadNumber{"nan", "'nan' is not a finite number", ""},
                      BadNumber{"-NaN", "'-NaN' is not a finite number", ""},
                      BadNumber{"inf", "'inf' is not a finite number", ""},
                      BadNumber{"+Infinity", "'+Infinity' is not a finite number", ""},
                      BadNumber{"1.#INF", "'1.#INF' is not a finite number", ""},
                      BadNumber{"1e39", "'1e39' is too large", "the largest number is 3.4e38"},
                      BadNumber{"-3.5e38", "'-3.5e38' is too large", "the largest number is 3.4e38"},
                      BadNumber{"1e99999999999999999999", "'1e99999999999999999999' is too large",
                                "the largest number is 3.4e38"},
                      BadNumber{"0,5", "'0,5' is not a number", "write the decimal point as '.': 0.5"},
                      BadNumber{"1,2,3", "'1,2,3' is not a number", "separate numbers with blanks, without commas"},
                      BadNumber{"1,", "'1,' is not a number", "write the decimal point as '.': 1."},
                      BadNumber{"1.0x", "'1.0x' is not a number: 'x' follows '1.0'", ""},
                      BadNumber{"0x10", "'0x10' is not a number: 'x10' follows '0'", ""},
                      BadNumber{"1.0f", "'1.0f' is not a number: 'f' follows '1.0'", ""},
                      BadNumber{"-1-1", "'-1-1' is not a number: it looks like two", "put a blank between: -1 -1"},
                      BadNumber{"0.5.5", "'0.5.5' is not a number: it looks like two", "put a blank between: 0.5 .5"},
                      BadNumber{"\u22125", "'\u22125' is not a number", "write the minus as '-': -5"},
                      BadNumber{"1e", "'1e' is not a number", ""}, BadNumber{"1e+", "'1e+' is not a number", ""},
                      BadNumber{".", "'.' is not a number", ""}, BadNumber{"-", "'-' is not a number", ""},
                      BadNumber{"--1", "'--1' is not a number", ""}, BadNumber{"one", "'one' is not a number", ""},
                      BadNumber{"\x01", "'\\x01' is not a number", ""}));

TEST(WholeNumbers, have_digits_only) {
    uint64_t value = 0;
    EXPECT_FALSE(read_whole_number("256", value));
    EXPECT_EQ(value, 256u);
    EXPECT_FALSE(read_whole_number("+007", value));
    EXPECT_EQ(value, 7u);
    EXPECT_FALSE(read_whole_number("99999999999999999999999", value));
    EXPECT_EQ(value, std::numeric_limits<uint64_t>::max());
    EXPECT_EQ(read_whole_number("-1", value).value().message, "'-1' is not a whole number from 0 up");
    EXPECT_EQ(read_whole_number("2.5", value).value().message, "'2.5' is not a whole number from 0 up");
    EXPECT_EQ(read_whole_number("1e3", value).value().message, "'1e3' is not a whole number from 0 up");
    EXPECT_EQ(read_whole_number("many", value).value().message, "'many' is not a number");
    EXPECT_EQ(read_whole_number("256,", value).value().hint, "write the decimal point as '.': 256.");
}

TEST(NumberShapes, bound_the_value_from_above) {
    const auto magnitude = [](std::string_view text) {
        return scan_number(text.data(), text.data() + text.size()).magnitude;
    };
    EXPECT_EQ(magnitude("999"), 3);
    EXPECT_EQ(magnitude("-0.5"), 1);
    EXPECT_EQ(magnitude("1e12"), 13);
    EXPECT_EQ(magnitude("12.5e-4"), -2);
    EXPECT_GT(magnitude("1e99999999999999999999"), 1000);
    EXPECT_LT(magnitude("1e-99999999999999999999"), -1000);
}

TEST(Hashes, belong_to_numbers_that_are_none_as_microsoft_writes_them) {
    for (const char *behind : {"INF", "IND", "QNAN", "SNAN00"}) EXPECT_TRUE(is_hash_of_a_number("eye -1.", behind));
    EXPECT_FALSE(is_hash_of_a_number("eye 1.", " INF"));
    EXPECT_FALSE(is_hash_of_a_number("eye 1.", ""));
    EXPECT_FALSE(is_hash_of_a_number("eye 1", "INF"));
    EXPECT_FALSE(is_hash_of_a_number("", "INF"));
}

} // namespace
} // namespace glint::test
