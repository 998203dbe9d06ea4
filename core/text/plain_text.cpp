// Telling text from what only has a text file's name.
#include "text/plain_text.hpp"

namespace glint {

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

bool check_is_text(std::string_view text, Problems &problems) {
    const size_t nul = text.find('\0');
    if (nul == std::string_view::npos) return true;
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
        problems.error({1, 1, {}}, "this is not UTF-8 text", "it looks like UTF-16: save it as UTF-8");
        return false;
    }
    Place place{1, 1, {}};
    for (size_t at = 0; at < nul; ++at) {
        const bool ends_line = text[at] == '\n' || (text[at] == '\r' && text[at + 1] != '\n');
        place.line += ends_line;
        place.column = ends_line ? 1 : place.column + 1;
    }
    problems.error(place, "this is not a text file: it has a NUL byte");
    return false;
}

std::optional<std::span<char>> plain_text_of(TextFile &file, Problems &problems) {
    if (!check_is_text(file.view(), problems)) return std::nullopt;
    const size_t mark_bytes = file.size - without_byte_order_mark(file.view()).size();
    return std::span<char>(file.bytes.get() + mark_bytes, file.size - mark_bytes);
}

} // namespace glint
