// An OBJ file's lines, joined where a backslash says that they go on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "text/problems.hpp"

namespace glint {

/// Walks over the logical lines of a text. LF, CRLF and CR end a line; a backslash before the end continues it, except
/// in a comment (which may well end in the path of a Windows folder).
class ObjLines {
public:
    explicit ObjLines(std::span<char> text) : next_(text.data()), text_end_(text.data() + text.size()) {}

    /// Goes to the next line, or returns false behind the last one.
    bool next();

    /// The logical line; a joined one still has its backslashes and newlines until join().
    [[nodiscard]] char *begin() const { return begin_; }
    [[nodiscard]] char *end() const { return end_; }

    /// Makes a joined line one line for every reader of the text, by writing blanks over backslashes and newlines.
    void join();

    /// Where a byte of the current line stands in the file.
    [[nodiscard]] Place place(const char *at) const;

private:
    char *begin_ = nullptr;
    char *end_ = nullptr;
    char *next_;
    char *text_end_;
    uint32_t line_ = 1;                   ///< number of the first of the current physical lines
    std::vector<char *> physical_begins_; ///< where each of the current physical lines begins; more than one if joined
};

/// What separates words within a line.
[[nodiscard]] inline bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

} // namespace glint
