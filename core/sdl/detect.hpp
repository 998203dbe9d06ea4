// Which dialect an SDL file is written in.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glint/read.hpp>

#include "sdl/dialects.hpp"
#include "text/problems.hpp"

namespace glint {

/// A dialect, and what decided for it.
struct DetectedDialect {
    Dialect dialect;
    std::string reason; ///< "'max_depth' on line 6"
    std::vector<DialectEvidence> evidence = {};
};

/// Looks at the whole text before any line of it is interpreted. `wanted` is the dialect the caller named, or empty; it
/// comes before the file's own `dialect` directive, which comes before all other evidence. Where nothing is evidence
/// the answer is mobile2013 (such a file has no object, so reading it will fail in any dialect). Returns nothing, after
/// one error, where the evidence fits no dialect or several, and where this version cannot read the one it fits.
[[nodiscard]] std::optional<DetectedDialect> detect_dialect(std::string_view text, std::string_view wanted,
                                                            Problems &problems);

} // namespace glint
