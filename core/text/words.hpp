// Putting messages together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace glint {

/// A text or a whole number, as words() takes them.
class Piece {
public:
    Piece(const char *text) : text_(text) {}
    Piece(std::string_view text) : text_(text) {}
    Piece(const std::string &text) : text_(text) {}
    Piece(char character) : number_(static_cast<unsigned char>(character)), kind_(Kind::character) {}
    template <typename Number>
        requires std::is_integral_v<Number>
    Piece(Number number)
        : number_(static_cast<uint64_t>(number)),
          kind_(std::is_signed_v<Number> ? Kind::signed_number : Kind::unsigned_number) {}

    void append_to(std::string &text) const;

private:
    enum class Kind : uint8_t { text, character, signed_number, unsigned_number };
    std::string_view text_;
    uint64_t number_ = 0;
    Kind kind_ = Kind::text;
};

[[nodiscard]] std::string join(std::span<const Piece> pieces);

/// The pieces - texts and whole numbers - one behind the other.
template <typename... Pieces> [[nodiscard]] std::string words(const Pieces &...pieces) {
    const Piece all[] = {Piece(pieces)...};
    return join(all);
}

/// The text between single quotes. Control bytes and bytes that are not UTF-8 show as \xNN; a long text is cut with
/// "...".
[[nodiscard]] std::string in_quotes(std::string_view text, size_t most_bytes = 48);

/// The same of a path, whose end tells the most.
[[nodiscard]] inline std::string path_in_quotes(std::string_view path) {
    return in_quotes(path, 4096);
}

/// A to Z become a to z; no other byte changes, in any locale.
[[nodiscard]] std::string lower_case(std::string_view text);

/// "1 triangle", "2 triangles".
[[nodiscard]] std::string counted(uint64_t count, std::string_view singular);

/// Length in bytes of the UTF-8 character at the start of `text`; 0 where there is none. `text` is not empty.
/// Follows the table of well-formed sequences in The Unicode Standard, chapter 3 (D92): no surrogates, nothing
/// overlong.
[[nodiscard]] size_t utf8_length(std::string_view text);

} // namespace glint
