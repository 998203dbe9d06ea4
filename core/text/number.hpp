// The strict numbers of scene files: read the same in every locale, never a surprise, each fault with its words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace glint {

/// Why a piece of text is not the number that was expected.
struct NumberFault {
    std::string message; ///< "'1.0x' is not a number: 'x' follows '1.0'"
    std::string hint;    ///< may be empty
};

/// Reads `[sign] digits [. digits] [exponent]` (a digit on one side of the point is enough) into the nearest float.
/// What is too small for a float becomes zero; what is too large is a fault, as are nan, inf and anything left over.
[[nodiscard]] std::optional<NumberFault> read_number(std::string_view token, float &value);

/// Reads digits, with a plus sign or none, into a whole number; what does not fit becomes the largest one.
[[nodiscard]] std::optional<NumberFault> read_whole_number(std::string_view token, uint64_t &value);

/// Whether the '#' between these two pieces of a line belongs to a number that is none, as Microsoft's library prints
/// them
/// ("1.#INF", "-1.#IND"), and begins no comment: what it leaves must not be taken for "1.".
[[nodiscard]] bool is_hash_of_a_number(std::string_view before, std::string_view behind);

/// What a number looks like, found without computing its value.
struct NumberShape {
    const char *end = nullptr; ///< just past the last character that belongs to the number
    bool valid = false;
    /// The absolute value is below 10^magnitude: digits before the point, plus the exponent. Saturates far beyond any
    /// float.
    int magnitude = 0;
    int exponent = 0; ///< as written; saturates likewise
};

/// Walks over a number that starts at `at`. Inline: OBJ files have millions.
[[nodiscard]] inline NumberShape scan_number(const char *at, const char *end) {
    constexpr int enough = 1000000;
    const auto is_digit = [&] { return at != end && static_cast<unsigned char>(*at - '0') < 10; };
    NumberShape shape;
    if (at != end && (*at == '-' || *at == '+')) ++at;
    const char *const digits = at;
    while (is_digit()) ++at;
    const std::ptrdiff_t before_point = at - digits;
    std::ptrdiff_t after_point = 0;
    if (at != end && *at == '.') {
        const char *const fraction = ++at;
        while (is_digit()) ++at;
        after_point = at - fraction;
    }
    shape.valid = before_point + after_point > 0;
    if (shape.valid && at != end && (*at == 'e' || *at == 'E')) {
        ++at;
        const bool negative = at != end && *at == '-';
        if (at != end && (*at == '-' || *at == '+')) ++at;
        shape.valid = is_digit();
        while (is_digit()) {
            if (shape.exponent < enough) shape.exponent = shape.exponent * 10 + (*at - '0');
            ++at;
        }
        if (negative) shape.exponent = -shape.exponent;
    }
    shape.magnitude = (before_point < enough ? static_cast<int>(before_point) : enough) + shape.exponent;
    shape.end = at;
    return shape;
}

} // namespace glint
