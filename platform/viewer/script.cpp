// Input events from a text file: what a person would do, repeatable.
#include "viewer/script.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace glint::viewer {

namespace {

constexpr std::pair<std::string_view, Key> key_names[] = {
    {"w", Key::w},         {"a", Key::a},         {"s", Key::s},       {"d", Key::d},           {"q", Key::q},
    {"e", Key::e},         {"r", Key::r},         {"f", Key::f},       {"p", Key::p},           {"h", Key::h},
    {"shift", Key::shift}, {"space", Key::space}, {"tab", Key::tab},   {"escape", Key::escape}, {"+", Key::plus},
    {"-", Key::minus},     {"up", Key::up},       {"down", Key::down}, {"0", Key::digit0},      {"1", Key::digit1},
    {"2", Key::digit2},    {"3", Key::digit3},    {"4", Key::digit4},  {"5", Key::digit5},      {"6", Key::digit6},
    {"7", Key::digit7},    {"8", Key::digit8},    {"9", Key::digit9},
};
constexpr std::pair<std::string_view, Button> button_names[] = {
    {"left", Button::left}, {"middle", Button::middle}, {"right", Button::right}};

template <typename Value, size_t count>
std::optional<Value> named(const std::pair<std::string_view, Value> (&names)[count], std::string_view name) {
    for (const auto &[known, value] : names) {
        if (known == name) return value;
    }
    return std::nullopt;
}

/// A script ends after a day; a picture's coordinates fit in a million pixels.
constexpr double most_seconds = 86400.0, most_pixels = 1e6, most_notches = 1000.0;
/// Moves a second that a drag consists of: as a mouse sends them. A drag ends after ten minutes, so that a short line
/// stays a small thing in memory.
constexpr double moves_per_second = 125.0, most_drag_seconds = 600.0;

/// One line, word by word. What is wrong with it is kept; the first problem counts.
class Line {
public:
    Line(std::string_view text, std::vector<TimedEvent> &events) : text_(text), events_(events) {}

    void read() {
        if (next_word_is_missing()) return; // empty
        seconds_ = number("a time in seconds", 0.0, most_seconds);
        const std::string_view what = word("what happens then");
        if (!problem_.empty()) return;
        const size_t what_column = column_;
        if (what == "press") {
            event_.button = button();
            place();
            add(InputEvent::Kind::button_down);
        } else if (what == "release") {
            event_.button = button();
            place();
            add(InputEvent::Kind::button_up);
        } else if (what == "move") {
            place();
            add(InputEvent::Kind::move);
        } else if (what == "drag") {
            drag();
        } else if (what == "wheel") {
            event_.amount = number("notches of the wheel", -most_notches, most_notches);
            place();
            add(InputEvent::Kind::wheel);
        } else if (what == "key") {
            key();
        } else if (what == "finger") {
            finger();
        } else if (what == "resize") {
            event_.width_px = static_cast<uint32_t>(number("a width in pixels", 1.0, 16384.0));
            event_.height_px = static_cast<uint32_t>(number("a height in pixels", 1.0, 16384.0));
            add(InputEvent::Kind::resize);
        } else if (what == "lose-context") {
            add(InputEvent::Kind::context_lost);
        } else if (what == "close") {
            add(InputEvent::Kind::close);
        } else {
            fail(what_column, "unknown event '" + std::string(what) +
                                  "', expected press, release, move, drag, wheel, key, finger, resize, lose-context or "
                                  "close");
        }
        if (problem_.empty() && !next_word_is_missing()) {
            fail(rest_ + 1, "nothing more was expected on this line");
        }
    }

    [[nodiscard]] const std::string &problem() const { return problem_; }
    [[nodiscard]] uint32_t column() const { return static_cast<uint32_t>(problem_column_); }

private:
    void fail(size_t column, std::string problem) {
        if (!problem_.empty()) return;
        problem_ = std::move(problem);
        problem_column_ = column;
    }

    bool next_word_is_missing() {
        while (rest_ < text_.size() && (text_[rest_] == ' ' || text_[rest_] == '\t' || text_[rest_] == '\r')) ++rest_;
        return rest_ == text_.size() || text_[rest_] == '#';
    }

    std::string_view word(const char *expected) {
        if (next_word_is_missing()) {
            fail(rest_ + 1, "expected " + std::string(expected));
            return {};
        }
        const size_t begin = rest_;
        while (rest_ < text_.size() && text_[rest_] != ' ' && text_[rest_] != '\t' && text_[rest_] != '\r') ++rest_;
        column_ = begin + 1;
        return text_.substr(begin, rest_ - begin);
    }

    double number(const char *expected, double least, double most) {
        const std::string_view text = word(expected);
        if (!problem_.empty()) return least;
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !(value >= least && value <= most)) {
            fail(column_, "'" + std::string(text) + "' is not " + expected);
            return least;
        }
        return value;
    }

    void place() {
        event_.x = number("a column in pixels", -most_pixels, most_pixels);
        event_.y = number("a row in pixels", -most_pixels, most_pixels);
    }

    Button button() {
        const std::string_view name = word("left, middle or right");
        const std::optional<Button> known = named(button_names, name);
        if (!known) fail(column_, "'" + std::string(name) + "' is not a button: left, middle or right");
        return known.value_or(Button::left);
    }

    void key() {
        const std::string_view name = word("a key's name");
        const std::optional<Key> known = named(key_names, name);
        if (!known) fail(column_, "'" + std::string(name) + "' is not a key that means something here");
        event_.key = known.value_or(Key::w);
        if (next_word_is_missing()) {
            add(InputEvent::Kind::key_down);
            add(InputEvent::Kind::key_up);
            return;
        }
        const std::string_view way = word("down or up");
        if (way != "down" && way != "up") fail(column_, "'" + std::string(way) + "' is neither down nor up");
        add(way == "up" ? InputEvent::Kind::key_up : InputEvent::Kind::key_down);
    }

    void finger() {
        event_.finger = static_cast<uint64_t>(number("a finger's number", 0.0, 1000.0));
        const std::string_view what = word("down, move or up");
        if (what != "down" && what != "move" && what != "up") {
            fail(column_, "'" + std::string(what) + "' is neither down, move nor up");
        }
        place();
        add(what == "down"   ? InputEvent::Kind::finger_down
            : what == "move" ? InputEvent::Kind::finger_move
                             : InputEvent::Kind::finger_up);
    }

    void drag() {
        event_.button = button();
        place();
        const double from_x = event_.x, from_y = event_.y;
        const double to_x = number("a column in pixels", -most_pixels, most_pixels);
        const double to_y = number("a row in pixels", -most_pixels, most_pixels);
        const double lasts = number("a time of up to 600 seconds", 0.0, most_drag_seconds);
        add(InputEvent::Kind::button_down);
        const double begin = seconds_;
        const double moves = std::max(1.0, std::floor(lasts * moves_per_second));
        for (double move = 1.0; move <= moves && problem_.empty(); ++move) {
            const double share = move / moves;
            seconds_ = begin + share * lasts;
            event_.x = from_x + share * (to_x - from_x);
            event_.y = from_y + share * (to_y - from_y);
            add(InputEvent::Kind::move);
        }
        add(InputEvent::Kind::button_up);
    }

    void add(InputEvent::Kind kind) {
        if (!problem_.empty()) return;
        event_.kind = kind;
        events_.push_back({seconds_, event_});
    }

    std::string_view text_;
    std::vector<TimedEvent> &events_;
    size_t rest_ = 0, column_ = 0; // where the next word is looked for, and where the last one began, from 1
    double seconds_ = 0.0;
    InputEvent event_;
    std::string problem_;
    size_t problem_column_ = 0;
};

} // namespace

Result<Script> Script::read(const std::filesystem::path &file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        return Error(ErrorCode::not_found, file.string() + ": there is no such file");
    }
    std::ifstream in(file, std::ios::binary);
    std::string text;
    const bool is_folder = std::filesystem::is_directory(file, error);
    if (!is_folder && in) text.assign(std::istreambuf_iterator<char>(in), {});
    if (is_folder || !in) return Error(ErrorCode::io, file.string() + " cannot be read");
    return parse(text, file.string());
}

Result<Script> Script::parse(std::string_view text, const std::string &name) {
    Script script;
    std::vector<Diagnostic> problems;
    constexpr size_t most_problems = 20;
    uint32_t number = 0;
    while (!text.empty() && problems.size() < most_problems) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        ++number;
        Line reader(line, script.events_);
        reader.read();
        if (reader.problem().empty()) continue;
        Diagnostic problem;
        problem.file = name;
        problem.line = number;
        problem.column = reader.column();
        problem.message = reader.problem();
        problem.source_line = std::string(line.substr(0, line.find('\r')));
        problems.push_back(std::move(problem));
    }
    if (!problems.empty()) return Error(ErrorCode::bad_input, std::move(problems));
    std::stable_sort(script.events_.begin(), script.events_.end(),
                     [](const TimedEvent &a, const TimedEvent &b) { return a.seconds < b.seconds; });
    return script;
}

void Script::take_until(double seconds, std::vector<TimedEvent> &events) {
    for (; next_ < events_.size() && events_[next_].seconds <= seconds; ++next_) events.push_back(events_[next_]);
}

std::optional<double> Script::next_seconds() const {
    if (next_ == events_.size()) return std::nullopt;
    return events_[next_].seconds;
}

} // namespace glint::viewer
