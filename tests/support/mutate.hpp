// Damage to a text, at random or by rule, for tests that a reader survives anything.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace glint::test {

/// The text after one to three changes: a byte replaced, inserted or taken out, a piece doubled, moved or cut off.
[[nodiscard]] inline std::string mutated(std::string_view original, Random &random) {
    constexpr std::string_view likely = "0123456789+-.,eE/\\#\r\n\t  \"'xnaif\xff\x80\x01";
    std::string text(original);
    for (uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
        const auto size = static_cast<uint32_t>(text.size());
        if (size < 2) break;
        const size_t at = random.below(size), length = 1 + random.below(8);
        const char byte = random.below(8) == 0 ? static_cast<char>(random.below(256))
                                               : likely[random.below(static_cast<uint32_t>(likely.size()))];
        switch (random.below(6)) {
        case 0:
            text[at] = byte;
            break;
        case 1:
            text.insert(at, 1, byte);
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(at, text.substr(at, length));
            break;
        case 4:
            text.insert(random.below(size), text.substr(at, length));
            break;
        default:
            if (random.below(4) == 0) text.resize(at);
        }
    }
    return text;
}

/// The words of a line.
using Words = std::vector<std::string>;

/// The text's lines; a comment is a word like any other.
[[nodiscard]] inline std::vector<Words> lines_of(std::string_view text) {
    std::vector<Words> lines(1);
    bool in_word = false;
    for (const char c : text) {
        if (c == '\n') lines.emplace_back();
        const bool is_blank = c == ' ' || c == '\n' || c == '\t';
        if (!is_blank && !in_word) lines.back().emplace_back();
        if (!is_blank) lines.back().back() += c;
        in_word = !is_blank;
    }
    return lines;
}

[[nodiscard]] inline std::string joined(const Words &words) {
    std::string text;
    for (const std::string &word : words) text += (text.empty() ? "" : " ") + word;
    return text + '\n';
}

/// All lines as one text, with `words` in the place of one of them.
[[nodiscard]] inline std::string text_with(const std::vector<Words> &lines, size_t line, const Words &words) {
    std::string text;
    for (size_t i = 0; i < lines.size(); ++i) text += joined(i == line ? words : lines[i]);
    return text;
}

/// Words that stand at an edge of what a number may be, or beyond it.
inline constexpr std::array<std::string_view, 34> extremes = {"0",          "-0",
                                                              "1",          "-1",
                                                              "0.5",        "1e-45",
                                                              "-1e-46",     "1e38",
                                                              "1e39",       "-1e39",
                                                              "1e12",       "-1e12",
                                                              "1.0001e12",  "1e-300",
                                                              "1e99999",    "16777217",
                                                              "4096",       "4097",
                                                              "1000",       "1001",
                                                              "8192",       "65536",
                                                              "2147483648", "4294967295",
                                                              "4294967296", "18446744073709551616",
                                                              "0.99999999", "1.00000001",
                                                              "180",        "nan",
                                                              "-inf",       "0x10",
                                                              "1,5",        "+7"};

/// What may become of a word.
enum class WordRule : uint32_t { left_out, doubled, swapped, extreme, glued, cut, signed_anew, byte_put_in, commented };
inline constexpr uint32_t word_rules = 9;

/// The words of a line after the rule has met one of them.
[[nodiscard]] inline Words changed(Words words, size_t at, WordRule rule, Random &random) {
    const auto place = [&](size_t i) { return words.begin() + static_cast<std::ptrdiff_t>(i); };
    const size_t other = random.below(static_cast<uint32_t>(words.size()));
    std::string &word = words[at];
    constexpr std::array<std::string_view, 8> bytes = {
        std::string_view("\0", 1), "\xff", "\xc2\xa0", "\xef\xbb\xbf", "\r", "\t", "\x1b", "\\"};
    switch (rule) {
    case WordRule::left_out:
        words.erase(place(at));
        break;
    case WordRule::doubled:
        words.insert(place(at), std::string(word));
        break;
    case WordRule::swapped:
        std::swap(words[at], words[other]);
        break;
    case WordRule::extreme:
        word = extremes[random.below(extremes.size())];
        break;
    case WordRule::glued:
        if (at + 1 < words.size()) {
            word += words[at + 1];
            words.erase(place(at + 1));
        }
        break;
    case WordRule::cut:
        word.resize(random.below(static_cast<uint32_t>(word.size() + 1)));
        break;
    case WordRule::signed_anew:
        word.insert(0, 1, random.below(2) == 0 ? '-' : '+');
        break;
    case WordRule::byte_put_in:
        word.insert(random.below(static_cast<uint32_t>(word.size() + 1)), bytes[random.below(bytes.size())]);
        break;
    case WordRule::commented:
        word.insert(0, 1, '#');
        break;
    }
    return words;
}

/// What may become of a line.
enum class LineRule : uint32_t { left_out, doubled, swapped, joined, cut_off, upper_case };
inline constexpr uint32_t line_rules = 6;

/// All lines as one text, after the rule has met one of them.
[[nodiscard]] inline std::string changed_lines(std::vector<Words> lines, size_t at, LineRule rule, Random &random) {
    const auto place = [&](size_t i) { return lines.begin() + static_cast<std::ptrdiff_t>(i); };
    switch (rule) {
    case LineRule::left_out:
        lines.erase(place(at));
        break;
    case LineRule::doubled:
        lines.insert(place(at), Words(lines[at]));
        break;
    case LineRule::swapped:
        std::swap(lines[at], lines[random.below(static_cast<uint32_t>(lines.size()))]);
        break;
    case LineRule::joined:
        if (at + 1 < lines.size()) {
            lines[at].insert(lines[at].end(), lines[at + 1].begin(), lines[at + 1].end());
            lines.erase(place(at + 1));
        }
        break;
    case LineRule::cut_off:
        lines.resize(at);
        break;
    case LineRule::upper_case:
        for (std::string &word : lines[at]) {
            for (char &c : word) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        }
        break;
    }
    std::string text;
    for (const Words &words : lines) text += glint::test::joined(words);
    return text;
}

} // namespace glint::test
