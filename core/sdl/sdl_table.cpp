// Directives as the lines of a table, for people to read.
#include "sdl/sdl_table.hpp"

#include <algorithm>
#include <string_view>

#include "sdl/lexer.hpp"

namespace glint {

namespace {

/// Longer words push the rest of their own line aside, not that of every line.
constexpr size_t widest_column = 80;

/// "[pattern]" and "'falloff'" without what surrounds them.
std::string_view bare(std::string_view argument) {
    const auto is_mark = [](char c) { return c == '[' || c == ']' || c == '\''; };
    while (!argument.empty() && is_mark(argument.front())) argument.remove_prefix(1);
    while (!argument.empty() && is_mark(argument.back())) argument.remove_suffix(1);
    return argument;
}

/// Adds a word, and blanks up to the next column.
void append(std::string &text, std::string_view word, size_t width) {
    text += word;
    text.append(word.size() < width ? width - word.size() + 1 : 1, ' ');
}

void end_line(std::string &text) {
    while (text.ends_with(' ')) text.pop_back();
    text += '\n';
}

const DirectiveForm *own_form(const Line &line) {
    for (const DirectiveForm &form : forms_of(line.tokens[0].text)) {
        if (form.dialects.has(Dialect::glint) && form.fits(line)) return &form;
    }
    return nullptr;
}

} // namespace

void SdlTable::add(std::string line) {
    Lexer lexer(line);
    Line words;
    if (!lexer.next(words)) return;
    Group &group = groups_[group_of(words)];
    const size_t group_index = static_cast<size_t>(&group - groups_.data());
    for (size_t i = 0; i < group.widths.size(); ++i) {
        const size_t width = words.tokens[i].text.size();
        if (width <= widest_column) group.widths[i] = std::max(group.widths[i], width);
    }
    rows_.push_back({std::move(line), group_index});
}

size_t SdlTable::group_of(const Line &line) {
    if (of_ == Of::settings) {
        if (groups_.empty()) groups_.push_back({nullptr, {}, {0}});
        return 0;
    }
    const DirectiveForm *const form = own_form(line);
    for (size_t i = 0; i < groups_.size(); ++i) {
        if (groups_[i].form == form && groups_[i].head.size() == line.tokens.size()) return i;
    }
    Group group{form, {"#" + std::string(line.tokens[0].text)}, {}};
    for (size_t i = 0; i < line.argument_count; ++i) {
        group.head.emplace_back(form ? bare(form->argument(i)) : std::string_view());
    }
    for (const std::string &word : group.head) group.widths.push_back(word.size());
    groups_.push_back(std::move(group));
    return groups_.size() - 1;
}

std::string SdlTable::text() const {
    if (rows_.empty()) return {};
    std::string text = "\n# " + title_ + '\n';
    std::vector<bool> has_head(groups_.size(), false);
    Line words;
    for (const Row &row : rows_) {
        const Group &group = groups_[row.group];
        if (!has_head[row.group] && group.form) {
            for (size_t i = 0; i < group.head.size(); ++i) append(text, group.head[i], group.widths[i]);
            end_line(text);
        }
        has_head[row.group] = true;
        Lexer lexer(row.line);
        if (!lexer.next(words)) continue;
        for (size_t i = 0; i < words.tokens.size(); ++i) {
            append(text, words.tokens[i].text, i < group.widths.size() ? group.widths[i] : 0);
        }
        end_line(text);
    }
    return text;
}

} // namespace glint
