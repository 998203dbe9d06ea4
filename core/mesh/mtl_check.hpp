// The pass over an MTL file's text that lets tinyobjloader see only what it reads rightly.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "text/kept_place.hpp"
#include "text/problems.hpp"

namespace glint {

/// What the check knows of a material besides the values, which tinyobjloader reads.
struct MtlEntry {
    std::string name;
    bool has_color = false;           ///< whether there is a Kd
    std::optional<KeptPlace> texture; ///< where the name of map_Kd's file stands
};

/// Checks every statement of the file and reports what is wrong, with its place. Returns the materials in order, each
/// name once.
///
/// The text is changed on the way, never in size: comments behind numbers and options of map_Kd become blanks, and
/// lines that a Material has no use for become comments.
[[nodiscard]] std::vector<MtlEntry> check_mtl(std::span<char> text, Problems &problems);

} // namespace glint
