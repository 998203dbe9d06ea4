// Putting messages together.
#include "text/words.hpp"

namespace glint {

void Piece::append_to(std::string &text) const {
    switch (kind_) {
    case Kind::text:
        text += text_;
        break;
    case Kind::character:
        text += static_cast<char>(number_);
        break;
    case Kind::signed_number:
        text += std::to_string(static_cast<int64_t>(number_));
        break;
    case Kind::unsigned_number:
        text += std::to_string(number_);
        break;
    }
}

std::string join(std::span<const Piece> pieces) {
    std::string text;
    for (const Piece &piece : pieces) piece.append_to(text);
    return text;
}

size_t utf8_length(std::string_view text) {
    const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto continues = [&](size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
    const unsigned first = byte(0), second = byte(1);
    if (first < 0x80) return 1;
    if (first < 0xc2 || first > 0xf4 || !continues(1)) return 0;
    if (first < 0xe0) return 2;
    if (!continues(2)) return 0;
    if (first < 0xf0) {
        const bool overlong = first == 0xe0 && second < 0xa0, surrogate = first == 0xed && second > 0x9f;
        return overlong || surrogate ? 0 : 3;
    }
    const bool overlong = first == 0xf0 && second < 0x90, beyond_unicode = first == 0xf4 && second > 0x8f;
    return !continues(3) || overlong || beyond_unicode ? 0 : 4;
}

std::string in_quotes(std::string_view text, size_t most_bytes) {
    constexpr char hex[] = "0123456789abcdef";
    std::string shown = "'";
    size_t at = 0;
    while (at < text.size() && at < most_bytes) {
        const auto byte = static_cast<unsigned char>(text[at]);
        const size_t length = utf8_length(text.substr(at));
        if (length == 0 || byte < 0x20 || byte == 0x7f) {
            shown += {'\\', 'x', hex[byte >> 4], hex[byte & 15]};
            ++at;
        } else {
            shown += text.substr(at, length);
            at += length;
        }
    }
    if (at < text.size()) shown += "...";
    return shown + '\'';
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char &c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

std::string counted(uint64_t count, std::string_view singular) {
    return words(count, ' ', singular, count == 1 ? "" : "s");
}

} // namespace glint
