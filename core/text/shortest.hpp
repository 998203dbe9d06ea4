// Numbers as text.
#pragma once

#include <string>

namespace glint {

/// The shortest text that reads back as this finite number, the same in every locale. (std::to_chars does as much, but
/// LLVM's C++ library did not have it for floats for years, and so no phone.)
[[nodiscard]] std::string shortest(float value);

} // namespace glint
