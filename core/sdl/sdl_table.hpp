// Directives as the lines of a table, for people to read.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sdl/dialects.hpp"

namespace glint {

/// Lines that stand below each other: settings, whose values stand in one column, or surfaces, where lines of the same
/// form share the widths of all their columns and the first of them has the names of its arguments above it, in a
/// comment.
class SdlTable {
public:
    enum class Of { settings, surfaces };

    SdlTable(std::string title, Of of) : title_(std::move(title)), of_(of) {}

    /// Words with single blanks between them, which fit a form of the dialect `glint`.
    void add(std::string line);
    /// An empty line, the title, as a comment, and the lines; nothing where there are none.
    [[nodiscard]] std::string text() const;

private:
    /// Lines that share their columns: of surfaces those that have the same form and as many arguments.
    struct Group {
        const DirectiveForm *form;     ///< nullptr of settings
        std::vector<std::string> head; ///< the comment's words
        std::vector<size_t> widths;    ///< of columns
    };
    struct Row {
        std::string line;
        size_t group;
    };

    size_t group_of(const Line &line);

    std::string title_;
    Of of_;
    std::vector<Group> groups_;
    std::vector<Row> rows_;
};

} // namespace glint
