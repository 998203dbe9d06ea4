// From the text of an MTL file to materials.
#pragma once

#include <string>
#include <vector>

#include <glint/result.hpp>
#include <glint/scene.hpp>

#include "text/kept_place.hpp"
#include "text/text_file.hpp"

namespace glint {

/// A material of an MTL file.
struct MtlMaterial {
    std::string name;
    Material material;       ///< its texture is not read yet
    std::string texture;     ///< the file, as the MTL file calls it; empty where it names none
    KeptPlace texture_place; ///< of that name
};

struct MtlFile {
    std::vector<MtlMaterial> materials; ///< in the file's order, each name once
    std::vector<Diagnostic> warnings;
};

/// Reads the materials of a text; `name` is what diagnostics call the file. May throw std::bad_alloc.
///
/// Kd is the colour of diffuse and ambient light, white where there is none; Ks that of the highlight, its largest
/// channel being ks; Ns the exponent, 1 where there is none; Tr or 1 - d the transmission, Ni the index of refraction.
/// Nothing in MTL makes a mirror here.
[[nodiscard]] Result<MtlFile> read_mtl_text(TextFile text, const std::string &name);

} // namespace glint
