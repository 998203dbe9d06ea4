// The strict numbers of scene files: read the same in every locale, never a surprise, each fault with its words.
#include "text/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include <fast_float/fast_float.h>

#include "text/words.hpp"

namespace glint {

namespace {

bool is_number(std::string_view text) {
    const NumberShape shape = scan_number(text.data(), text.data() + text.size());
    return shape.valid && shape.end == text.data() + text.size();
}

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
    std::string result;
    while (!text.empty()) {
        const bool here = text.starts_with(from);
        result += here ? to : text.substr(0, 1);
        text.remove_prefix(here ? from.size() : 1);
    }
    return result;
}

/// Whether the token is one of the ways to write "not a number" or "infinity" (those of C, and of MSVC: "1.#INF").
bool is_not_finite(std::string_view token) {
    std::string word = lower_case(token);
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.erase(0, 1);
    return word == "inf" || word == "infinity" || word == "nan" || word.starts_with("nan(") || word.starts_with("1.#");
}

/// Finds words for a token that is no number. Slow, and for people.
NumberFault explain(std::string_view token) {
    if (is_not_finite(token)) return {words(in_quotes(token), " is not a finite number"), {}};
    const std::string found = words(in_quotes(token), " is not a number");

    const std::string with_points = replaced(token, ",", ".");
    if (with_points != token) {
        if (is_number(with_points)) return {found, words("write the decimal point as '.': ", with_points)};
        return {found, "separate numbers with blanks, without commas"};
    }
    // U+2212 MINUS SIGN and U+2013 EN DASH come along when numbers are copied from a formatted page.
    const std::string with_minus = replaced(replaced(token, "\u2212", "-"), "\u2013", "-");
    if (with_minus != token && is_number(with_minus)) return {found, words("write the minus as '-': ", with_minus)};

    const NumberShape shape = scan_number(token.data(), token.data() + token.size());
    const std::string_view number(token.data(), static_cast<size_t>(shape.end - token.data()));
    const std::string_view rest = token.substr(number.size());
    if (!shape.valid || rest.empty()) return {found, {}};
    if ((rest[0] == '-' || rest[0] == '+' || rest[0] == '.') && is_number(rest)) {
        return {words(found, ": it looks like two"), words("put a blank between: ", number, ' ', rest)};
    }
    return {words(found, ": ", in_quotes(rest), " follows ", in_quotes(number)), {}};
}

} // namespace

std::optional<NumberFault> read_number(std::string_view token, float &value) {
    const char *const end = token.data() + token.size();
    const NumberShape shape = scan_number(token.data(), end);
    if (!shape.valid || shape.end != end) return explain(token);

    // from_chars takes no plus sign. What is too large becomes infinite, what is too small becomes zero.
    const char *const begin = token.data() + (token[0] == '+' ? 1 : 0);
    fast_float::from_chars(begin, end, value);
    if (std::isfinite(value)) return std::nullopt;
    return NumberFault{words(in_quotes(token), " is too large"), "the largest number is 3.4e38"};
}

bool is_hash_of_a_number(std::string_view before, std::string_view behind) {
    return before.ends_with("1.") && (behind.starts_with("INF") || behind.starts_with("IND") ||
                                      behind.starts_with("QNAN") || behind.starts_with("SNAN"));
}

std::optional<NumberFault> read_whole_number(std::string_view token, uint64_t &value) {
    const std::string_view digits = token.substr(token.starts_with('+') ? 1 : 0);
    const bool all_digits = std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits.empty() && all_digits) {
        if (std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc()) {
            value = std::numeric_limits<uint64_t>::max();
        }
        return std::nullopt;
    }
    if (is_number(token)) return NumberFault{words(in_quotes(token), " is not a whole number from 0 up"), {}};
    return explain(token);
}

} // namespace glint
