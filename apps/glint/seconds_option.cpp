// --seconds: how long to measure.
#include "seconds_option.hpp"

#include <charconv>

#include <fmt/format.h>

namespace glint::cli {

CLI::Option *add_seconds(CLI::App &parser, double &target, const std::string &description) {
    const CLI::Validator in_bounds(
        [](const std::string &text) {
            double seconds = 0.0;
            const char *const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, seconds);
            const bool number = error == std::errc() && stop == end;
            return number && seconds >= 0.0 && seconds <= 3600.0
                       ? std::string()
                       : fmt::format("'{}' is not a number of seconds from 0 to 3600", text);
        },
        "");
    return parser.add_option("--seconds", target, description)->check(in_bounds)->type_name("S");
}

} // namespace glint::cli
