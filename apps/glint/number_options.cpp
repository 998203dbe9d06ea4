// Options whose values are whole numbers, read strictly: digits and nothing else, within stated bounds.
#include "number_options.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace glint::cli {
namespace {

/// The number, or the end of the parse.
uint64_t require(const std::string &flag, std::string_view text, Bounds bounds) {
    if (const auto value = parse_whole_number(text, bounds)) return *value;
    throw CLI::ValidationError(flag,
                               fmt::format("'{}' is not a whole number from {} to {}", text, bounds.min, bounds.max));
}

template <typename Number> CLI::Option *add_one(CLI::App &parser, const std::string &flag,
                                                std::optional<Number> &target, Bounds bounds,
                                                const std::string &description) {
    const auto read = [&target, flag, bounds](const std::string &text) {
        target = static_cast<Number>(require(flag, text, bounds));
    };
    return parser.add_option_function<std::string>(flag, read, description)->type_name("N");
}

} // namespace

std::optional<uint64_t> parse_whole_number(std::string_view text, Bounds bounds) {
    uint64_t value = 0;
    const char *const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || value < bounds.min || value > bounds.max) return std::nullopt;
    return value;
}

std::optional<Size> parse_size(std::string_view text) {
    const size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto width = parse_whole_number(text.substr(0, cross), side_bounds);
    const auto height = parse_whole_number(text.substr(cross + 1), side_bounds);
    if (!width || !height) return std::nullopt;
    return Size{static_cast<uint32_t>(*width), static_cast<uint32_t>(*height)};
}

CLI::Option *add_number(CLI::App &parser, const std::string &flag, std::optional<uint64_t> &target, Bounds bounds,
                        const std::string &description) {
    return add_one(parser, flag, target, bounds, description);
}

CLI::Option *add_number(CLI::App &parser, const std::string &flag, std::optional<uint32_t> &target, Bounds bounds,
                        const std::string &description) {
    return add_one(parser, flag, target, bounds, description);
}

CLI::Option *add_numbers(CLI::App &parser, const std::string &flag, std::vector<uint32_t> &target, Bounds bounds,
                         const std::string &description) {
    const auto read = [&target, flag, bounds](const std::string &text) {
        target.clear();
        for (size_t start = 0; start <= text.size();) {
            const size_t comma = std::min(text.find(',', start), text.size());
            const std::string_view item = std::string_view(text).substr(start, comma - start);
            target.push_back(static_cast<uint32_t>(require(flag, item, bounds)));
            start = comma + 1;
        }
    };
    return parser.add_option_function<std::string>(flag, read, description)->type_name("N,N,...");
}

CLI::Option *add_size(CLI::App &parser, const std::string &flag, std::optional<Size> &target,
                      const std::string &description) {
    const auto read = [&target, flag](const std::string &text) {
        target = parse_size(text);
        if (target) return;
        throw CLI::ValidationError(flag, fmt::format("'{}' is not a size like 640x480, each side from {} to {}", text,
                                                     side_bounds.min, side_bounds.max));
    };
    return parser.add_option_function<std::string>(flag, read, description)->type_name("WxH");
}

} // namespace glint::cli
