// The MTL files that one OBJ file names.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <glint/read.hpp>

#include "mesh/obj_check.hpp"
#include "mesh/read_mtl.hpp"
#include "mesh/texture_library.hpp"
#include "text/asset_paths.hpp"

namespace glint {

/// Reads the libraries of one OBJ file and finds materials in them.
class MaterialLibraries {
public:
    /// `paths` are those of the OBJ file, and `problems` its own; all arguments must outlive this object.
    MaterialLibraries(const AssetPaths &paths, const ReadOptions &options, TextureLibrary &textures, Problems &problems)
        : paths_(paths), options_(options), textures_(textures), problems_(problems) {}

    /// Reads what an `mtllib` line names, files that were read already left aside.
    void read(const ObjNames::Library &line);

    /// The material of this name, with its texture, which `usemtl` wants at `place`; one of the first library that has
    /// one. What is not there is reported, with the most similar name; so call this only where read() found no problem.
    [[nodiscard]] Material find(const std::string &name, const Place &place);

    /// Every library that was read, in order.
    [[nodiscard]] const std::vector<std::filesystem::path> &files() const { return files_; }

private:
    struct Entry {
        MtlMaterial material;
        size_t file;                  ///< into files_
        bool has_texture_yet = false; ///< whether its texture was looked for
    };

    void read_file(const std::filesystem::path &file, const Place &place);
    void tell_of_missing(const std::string &name, const Place &place);

    const AssetPaths &paths_;
    const ReadOptions &options_;
    TextureLibrary &textures_;
    Problems &problems_;
    std::map<std::string, Entry> materials_;
    std::vector<std::filesystem::path> files_;
    std::set<std::filesystem::path> seen_; ///< without symbolic links
};

} // namespace glint
