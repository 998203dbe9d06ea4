// Which frames of a moving scene are rendered, and what their files are called.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include <glint/result.hpp>

namespace glint::cli {

/// Both included.
struct FrameRange {
    uint32_t first;
    uint32_t last;
};

/// "0..99": rising, each at most a million.
[[nodiscard]] std::optional<FrameRange> parse_frame_range(std::string_view text);

/// Adds --frames; a value that is not valid ends the parse. `target` must live as long as the parser.
CLI::Option *add_frame_range(CLI::App &parser, const std::string &flag, std::optional<FrameRange> &target,
                             const std::string &description);

/// A file name with one place for the frame's number: "%d", or "%04d" for at least four digits.
class FramePattern {
public:
    /// Fails where there is no such place, or anything else begins with '%'.
    [[nodiscard]] static Result<FramePattern> parse(const std::string &text);

    [[nodiscard]] std::filesystem::path file(uint32_t frame) const;

private:
    std::string before_, after_;
    size_t digits_ = 0; ///< at least
};

} // namespace glint::cli
