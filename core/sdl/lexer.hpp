// From the text of an SDL file to lines of words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "text/problems.hpp"

namespace glint {

/// A word of a line; it ends at a blank or a comment.
struct Token {
    std::string_view text;
    uint32_t column = 0; ///< from 1, in bytes
};

/// One directive: a keyword and its arguments.
struct Line {
    /// More words than any directive has; further ones of a line are counted, not kept.
    static constexpr size_t most_tokens = 64;

    uint32_t number = 0;
    std::string_view source;   ///< the whole line, without its newline
    std::vector<Token> tokens; ///< the keyword first; never empty
    uint64_t argument_count = 0;
    bool has_problem = false; ///< whether a problem of its characters was reported

    [[nodiscard]] Place place(const Token &token) const { return {number, token.column, source}; }
};

/// Walks over the lines of a text that have words. LF, CRLF or CR ends a line, blanks and tabs separate words, '#'
/// starts a comment anywhere but in "1.#INF". The lines point into the text.
class Lexer {
public:
    /// Where `problems` are given, the first byte of a line that is not UTF-8 is reported, or the first character
    /// outside its comment that only looks like a blank.
    explicit Lexer(std::string_view text, Problems *problems = nullptr) : rest_(text), problems_(problems) {}

    /// Fills `line` with the next one, or returns false behind the last.
    bool next(Line &line);

private:
    void take_physical_line(Line &line);
    [[nodiscard]] bool check_characters(const Line &line, size_t code_bytes);

    std::string_view rest_;
    Problems *problems_;
    uint32_t line_count_ = 0;
};

} // namespace glint
