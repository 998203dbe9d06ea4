// From the text of an SDL file to lines of words.
#include "sdl/lexer.hpp"

#include <algorithm>

#include "text/number.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// What looks like a blank or like nothing, and is neither: it comes along when lines are copied from formatted pages.
struct FalseBlank {
    std::string_view bytes, name, hint;
};
constexpr std::string_view put_a_blank = "put a plain blank there";
constexpr FalseBlank false_blanks[] = {
    {"\u00a0", "a no-break space (U+00A0)", put_a_blank},
    {"\u2007", "a figure space (U+2007)", put_a_blank},
    {"\u202f", "a narrow no-break space (U+202F)", put_a_blank},
    {"\u3000", "an ideographic space (U+3000)", put_a_blank},
    {"\u200b", "a zero width space (U+200B)", "it cannot be seen; take it out"},
    {"\ufeff", "a byte-order mark (U+FEFF) inside the file", "it cannot be seen; take it out"},
};

const FalseBlank *false_blank_at(std::string_view text) {
    if (static_cast<unsigned char>(text[0]) < 0x80) return nullptr;
    for (const FalseBlank &blank : false_blanks) {
        if (text.starts_with(blank.bytes)) return &blank;
    }
    return nullptr;
}

/// Length of what separates words at the start of `text`, 0 where there is a word. False blanks separate, too: they are
/// told of, and what stands between them need not be told of again.
size_t blank_length(std::string_view text) {
    if (text[0] == ' ' || text[0] == '\t') return 1;
    const FalseBlank *const blank = false_blank_at(text);
    return blank ? blank->bytes.size() : 0;
}

/// Where the line's comment begins; its end where it has none.
size_t comment_begin(std::string_view line) {
    size_t at = line.find('#');
    while (at < line.size() && is_hash_of_a_number(line.substr(0, at), line.substr(at + 1)))
        at = line.find('#', at + 1);
    return std::min(at, line.size());
}

} // namespace

bool Lexer::next(Line &line) {
    while (!rest_.empty()) {
        take_physical_line(line);
        const std::string_view code = line.source.substr(0, comment_begin(line.source));
        line.has_problem = problems_ && !check_characters(line, code.size());
        line.tokens.clear();
        uint64_t count = 0;
        for (size_t at = 0; at < code.size();) {
            if (const size_t length = blank_length(code.substr(at))) {
                at += length;
                continue;
            }
            const size_t begin = at;
            while (at < code.size() && blank_length(code.substr(at)) == 0) ++at;
            if (++count <= Line::most_tokens) {
                line.tokens.push_back({code.substr(begin, at - begin), static_cast<uint32_t>(begin + 1)});
            }
        }
        line.argument_count = count - 1;
        if (count > 0) return true;
    }
    return false;
}

void Lexer::take_physical_line(Line &line) {
    const size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line.source = rest_.substr(0, end);
    line.number = ++line_count_;
    rest_.remove_prefix(end);
    if (rest_.starts_with("\r\n")) {
        rest_.remove_prefix(2);
    } else if (!rest_.empty()) {
        rest_.remove_prefix(1);
    }
}

bool Lexer::check_characters(const Line &line, size_t code_bytes) {
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    if (std::all_of(line.source.begin(), line.source.end(), is_ascii)) return true;
    for (size_t at = 0; at < line.source.size();) {
        const std::string_view rest = line.source.substr(at);
        const Place place = {line.number, static_cast<uint32_t>(at + 1), line.source};
        const size_t length = utf8_length(rest);
        if (length == 0) {
            problems_->error(place, words("byte ", in_quotes(rest.substr(0, 1)), " is not UTF-8"),
                             "save the file as UTF-8 or ASCII");
            return false;
        }
        if (const FalseBlank *const blank = at < code_bytes ? false_blank_at(rest) : nullptr) {
            problems_->error(place, words("there is ", blank->name), std::string(blank->hint));
            return false;
        }
        at += length;
    }
    return true;
}

} // namespace glint
