// The words of a line of an OBJ or MTL file, which may be written over.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "mesh/obj_lines.hpp"
#include "text/shortest.hpp"

namespace glint {

/// One word of a line, without the comment that may follow.
struct Word {
    char *begin;
    char *end;
    [[nodiscard]] std::string_view text() const { return {begin, static_cast<size_t>(end - begin)}; }
};

[[nodiscard]] inline char *skip_blanks(char *at, const char *end) {
    while (at != end && is_blank(*at)) ++at;
    return at;
}

[[nodiscard]] inline bool ends_word(const char *at, const char *end) {
    return at == end || is_blank(*at) || *at == '#';
}

[[nodiscard]] inline Word word_at(char *begin, const char *end) {
    char *at = begin;
    while (!ends_word(at, end)) ++at;
    return {begin, at};
}

/// What stands from `begin` to the end of the line, without blanks around it. Names of materials and files go so far;
/// neither blanks nor '#' end them, in no reader of these files.
[[nodiscard]] inline Word rest_of_line(char *begin, char *end) {
    begin = skip_blanks(begin, end);
    while (end != begin && is_blank(end[-1])) --end;
    return {begin, end};
}

/// Writes a number's shortest form over the word, where that is no longer. So tinyobjloader reads what was meant: it
/// loses numbers of many digits or with great exponents.
inline void write_shortest(const Word &word, float value) {
    const std::string text = shortest(value);
    if (text.size() > word.text().size()) return;
    std::fill(std::copy(text.begin(), text.end(), word.begin), word.end, ' ');
}

} // namespace glint
