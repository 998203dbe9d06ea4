// Which Glint this is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glint/export.hpp>
#include <glint/version.h>

namespace glint {

/// Facts about the library that a report should carry.
struct BuildInfo {
    std::string_view version;           ///< "0.1.0"
    std::string_view compiler;          ///< name and version of the compiler that built the library
    std::string_view glm_version;       ///< of the headers it was built with
    std::string_view highway_version;   ///< likewise
    std::vector<std::string_view> isas; ///< instruction sets to choose from on this machine
    std::string_view isa;               ///< the one in use where nobody chooses
};

[[nodiscard]] GLINT_API BuildInfo build_info();

} // namespace glint
