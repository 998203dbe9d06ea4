// What the program says: results on standard output, everything else on standard error.
#pragma once

#include <string_view>

namespace glint::cli {

/// Adds to standard output. A failure is kept for finish_output.
void print(std::string_view text);

/// Sends what is still held back on its way. False, after an error message, when any of it could not be written: a full
/// disk must not look like success.
[[nodiscard]] bool finish_output();

/// `glint: text` and a newline on standard error.
void complain(std::string_view text);

/// Whether standard error is a terminal, where a progress bar has someone to look at it.
[[nodiscard]] bool someone_watches();

} // namespace glint::cli
