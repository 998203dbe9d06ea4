// Putting messages together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace glint {

/// The pieces - texts and whole numbers - one behind the other.
template <typename... Pieces> [[nodiscard]] std::string words(const Pieces &...pieces) {
    std::string text;
    const auto append = [&text](const auto &piece) {
        if constexpr (std::is_integral_v<std::decay_t<decltype(piece)>> &&
                      !std::is_same_v<std::decay_t<decltype(piece)>, char>) {
            text += std::to_string(piece);
        } else {
            text += piece;
        }
    };
    (append(pieces), ...);
    return text;
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
