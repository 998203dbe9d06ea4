// Telling text from what only has a text file's name.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "text/problems.hpp"
#include "text/text_file.hpp"

namespace glint {

/// The text behind its UTF-8 byte-order mark, if it has one.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);

/// False, with one error, where `text` has a NUL byte: no text file has, and nothing in it would be worth reporting.
[[nodiscard]] bool check_is_text(std::string_view text, Problems &problems);

/// The bytes of the file's text, without the mark, to be read and written over; nothing, after one error, where it is
/// no text.
[[nodiscard]] std::optional<std::span<char>> plain_text_of(TextFile &file, Problems &problems);

} // namespace glint
