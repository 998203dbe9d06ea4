// Which frames of a moving scene are rendered, and what their files are called.
#include "frame_options.hpp"

#include <fmt/format.h>

#include "number_options.hpp"

namespace glint::cli {
namespace {

constexpr Bounds frame_bounds{0, 1'000'000};

} // namespace

std::optional<FrameRange> parse_frame_range(std::string_view text) {
    const size_t dots = text.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    const auto first = parse_whole_number(text.substr(0, dots), frame_bounds);
    const auto last = parse_whole_number(text.substr(dots + 2), frame_bounds);
    if (!first || !last || *first > *last) return std::nullopt;
    return FrameRange{static_cast<uint32_t>(*first), static_cast<uint32_t>(*last)};
}

CLI::Option *add_frame_range(CLI::App &parser, const std::string &flag, std::optional<FrameRange> &target,
                             const std::string &description) {
    const auto read = [&target, flag](const std::string &text) {
        target = parse_frame_range(text);
        if (target) return;
        throw CLI::ValidationError(flag, fmt::format("'{}' is not a range of frames like 0..99, each from {} to {}",
                                                     text, frame_bounds.min, frame_bounds.max));
    };
    return parser.add_option_function<std::string>(flag, read, description)->type_name("A..B");
}

Result<FramePattern> FramePattern::parse(const std::string &text) {
    const auto refused = [&](std::string_view why) {
        return Error(ErrorCode::bad_input, fmt::format("'{}' {}; frames go to files like frame.%04d.png", text, why));
    };
    const size_t percent = text.find('%');
    if (percent == std::string::npos) return refused("has no %d for the number of a frame");
    if (text.find('%', percent + 1) != std::string::npos) return refused("has more than one %");
    size_t end = percent + 1;
    FramePattern pattern;
    if (text[end] == '0') {
        ++end;
        if (text[end] < '1' || text[end] > '9') return refused("has a % that is no %d");
        pattern.digits_ = static_cast<size_t>(text[end++] - '0');
    }
    if (text[end] != 'd') return refused("has a % that is no %d");
    pattern.before_ = text.substr(0, percent);
    pattern.after_ = text.substr(end + 1);
    return pattern;
}

std::filesystem::path FramePattern::file(uint32_t frame) const {
    return before_ + fmt::format("{:0{}}", frame, digits_) + after_;
}

} // namespace glint::cli
