// A text as if it had been read from a file.
#pragma once

#include <string_view>

#include "text/text_file.hpp"

namespace glint::test {

/// Without a byte behind the last one, so that sanitizers see whoever reads further.
[[nodiscard]] inline TextFile text_in_memory(std::string_view text) {
    return TextFile::copy_of(text);
}

} // namespace glint::test
