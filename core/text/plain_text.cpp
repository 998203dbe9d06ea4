// Telling text from what only has a text file's name.
#include "text/plain_text.hpp"

#include <algorithm>

namespace glint {

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

bool check_is_text(std::string_view text, Problems &problems) {
    const size_t nul = text.find('\0');
    if (nul == std::string_view::npos) return true;
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
        problems.error({}, "this is not UTF-8 text", "it looks like UTF-16: save it as UTF-8");
        return false;
    }
    const std::string_view before = text.substr(0, nul);
    const auto line = static_cast<uint32_t>(1 + std::count(before.begin(), before.end(), '\n'));
    const auto column = static_cast<uint32_t>(nul - (before.rfind('\n') + 1) + 1); // npos + 1 is 0
    problems.error({line, column, {}}, "this is not a text file: it has a NUL byte");
    return false;
}

std::optional<std::span<char>> plain_text_of(TextFile &file, Problems &problems) {
    if (!check_is_text(file.view(), problems)) return std::nullopt;
    const size_t mark_bytes = file.size - without_byte_order_mark(file.view()).size();
    return std::span<char>(file.bytes.get() + mark_bytes, file.size - mark_bytes);
}

} // namespace glint
