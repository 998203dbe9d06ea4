// From the text of an SDL file to lines of words.
#include "sdl/lexer.hpp"

#include <algorithm>

#include "text/words.hpp"

namespace glint {

bool Lexer::next(Line &line) {
    constexpr std::string_view blanks = " \t";
    while (!rest_.empty()) {
        take_physical_line(line);
        if (problems_) check_utf8(line);
        line.tokens.clear();
        uint64_t count = 0;
        const std::string_view code = line.source.substr(0, line.source.find('#'));
        size_t begin = code.find_first_not_of(blanks);
        while (begin != std::string_view::npos) {
            const size_t end = std::min(code.find_first_of(blanks, begin), code.size());
            if (++count <= Line::most_tokens) {
                line.tokens.push_back({code.substr(begin, end - begin), static_cast<uint32_t>(begin + 1)});
            }
            begin = code.find_first_not_of(blanks, end);
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

void Lexer::check_utf8(const Line &line) {
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    if (std::all_of(line.source.begin(), line.source.end(), is_ascii)) return;
    for (size_t at = 0; at < line.source.size();) {
        const size_t length = utf8_length(line.source.substr(at));
        if (length == 0) {
            problems_->error({line.number, static_cast<uint32_t>(at + 1), line.source},
                             words("byte ", in_quotes(line.source.substr(at, 1)), " is not UTF-8"),
                             "save the file as UTF-8 or ASCII");
            return;
        }
        at += length;
    }
}

} // namespace glint
