// Telling text from what only has a text file's name.
#pragma once

#include <string_view>

#include "text/problems.hpp"

namespace glint {

/// The text behind its UTF-8 byte-order mark, if it has one.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);

/// False, with one error, where `text` has a NUL byte: no text file has, and nothing in it would be worth reporting.
[[nodiscard]] bool check_is_text(std::string_view text, Problems &problems);

} // namespace glint
