// Which Highway the packet kernels were built with.
#pragma once

#include <string_view>

namespace glint {

/// "1.0.3"
[[nodiscard]] std::string_view highway_version();

} // namespace glint
