// Options whose values are whole numbers, read strictly: digits and nothing else, within stated bounds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace glint::cli {

/// Inclusive.
struct Bounds {
    uint64_t min;
    uint64_t max;
};

inline constexpr Bounds thread_bounds{1, 1024};
inline constexpr Bounds depth_bounds{0, 1000};
inline constexpr Bounds side_bounds{1, 1u << 20}; ///< a picture's width or height, in pixels

/// The number that `text` is, in full; nothing for signs, blanks, other bases, junk, or what is out of bounds.
[[nodiscard]] std::optional<uint64_t> parse_whole_number(std::string_view text, Bounds bounds);

struct Size {
    uint32_t width_px;
    uint32_t height_px;
};

/// "640x480"; both sides within side_bounds.
[[nodiscard]] std::optional<Size> parse_size(std::string_view text);

// Each adds an option to `parser`; a value that is not valid ends the parse with a message that names the bounds.
// `target` must live as long as the parser.
CLI::Option *add_number(CLI::App &parser, const std::string &flag, std::optional<uint64_t> &target, Bounds bounds,
                        const std::string &description);
CLI::Option *add_number(CLI::App &parser, const std::string &flag, std::optional<uint32_t> &target, Bounds bounds,
                        const std::string &description);
CLI::Option *add_numbers(CLI::App &parser, const std::string &flag, std::vector<uint32_t> &target, Bounds bounds,
                         const std::string &description);
CLI::Option *add_size(CLI::App &parser, const std::string &flag, std::optional<Size> &target,
                      const std::string &description);

} // namespace glint::cli
