// Input events from a text file: what a person would do, repeatable.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glint/result.hpp>

#include "viewer/input.hpp"

namespace glint::viewer {

/// An event and when it happens: so many seconds after the viewer began.
struct TimedEvent {
    double seconds = 0.0;
    InputEvent event;
};

/// A script's events in the order of their times.
///
/// A line is a time in seconds and what happens then; `#` begins a comment:
///
///     0.5  press left 100 200        a button goes down there: left, middle or right
///     0.9  move 150 200              the cursor moves
///     1.0  release left 150 200
///     1.0  drag right 10 10 90 10 2  press, move evenly for 2 seconds, release
///     3.5  wheel -2 256 256          notches, with the cursor there
///     4    key w down                or up; without either, pressed and released
///     5    finger 1 down 100 100     or move, or up
///     6    resize 640 480
///     7    lose-context
///     8    close
///
/// Keys are called w a s d q e r f p h, 0 to 9, + and -, shift, space, tab, escape, up, down.
class Script {
public:
    Script() = default;
    /// Fails with not_found or io where the file cannot be read, with bad_input where a line makes no sense: every such
    /// line is a diagnostic.
    [[nodiscard]] static Result<Script> read(const std::filesystem::path &file);
    /// `name` is the file's in diagnostics.
    [[nodiscard]] static Result<Script> parse(std::string_view text, const std::string &name);

    /// Appends the events since the last call's time, up to and with those of `seconds`.
    void take_until(double seconds, std::vector<TimedEvent> &events);
    /// When the next event is; nothing where none is left.
    [[nodiscard]] std::optional<double> next_seconds() const;
    [[nodiscard]] const std::vector<TimedEvent> &events() const { return events_; }

private:
    std::vector<TimedEvent> events_;
    size_t next_ = 0;
};

} // namespace glint::viewer
