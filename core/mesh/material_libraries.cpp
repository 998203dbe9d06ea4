// The MTL files that one OBJ file names.
#include "mesh/material_libraries.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "mesh/obj_lines.hpp"
#include "text/asset_file.hpp"
#include "text/suggest.hpp"
#include "text/words.hpp"

namespace glint {

namespace fs = std::filesystem;

namespace {

constexpr const char *kind = "material library";

/// Names among which a similar one is looked for; a hundred faults times a hundred thousand names would take seconds.
constexpr size_t most_to_compare = 1000;

} // namespace

void MaterialLibraries::read(const ObjNames::Library &line) {
    // A name with blanks, as many programs write it, or several names, as the format's authors meant it.
    if (const Result<fs::path> whole = paths_.find(line.names); whole.ok() && paths_.files().is_file(*whole)) {
        return read_file(*whole, line.place.place());
    }
    std::string_view rest = line.names;
    while (!rest.empty() && rest.front() != '#') {
        const auto end = static_cast<size_t>(std::find_if(rest.begin(), rest.end(), is_blank) - rest.begin());
        Place place = line.place.place();
        // Of a continued line only the first piece is kept; a name behind it is told of at the first name's place.
        const auto offset = static_cast<uint32_t>(rest.data() - line.names.data());
        if (place.column + offset <= place.source_line.size()) place.column += offset;
        if (const auto file = find_asset(paths_, rest.substr(0, end), place, problems_)) read_file(*file, place);
        rest.remove_prefix(end);
        while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
    }
}

void MaterialLibraries::read_file(const fs::path &file, const Place &place) {
    if (!seen_.insert(real_path(paths_.files(), file)).second) return;
    std::optional<TextFile> text = read_asset(paths_.files(), file, kind, options_.max_file_bytes, place, problems_);
    if (!text) return;
    Result<MtlFile> library = read_mtl_text(std::move(*text), file.string());
    if (!library.ok()) return problems_.adopt(std::move(library).error(), place);
    problems_.adopt(std::move(library->warnings));
    for (MtlMaterial &material : library->materials) {
        std::string name = material.name;
        materials_.try_emplace(std::move(name), Entry{std::move(material), files_.size()});
    }
    files_.push_back(file);
}

Material MaterialLibraries::find(const std::string &name, const Place &place) {
    const auto found = materials_.find(name);
    if (found == materials_.end()) return tell_of_missing(name, place), Material();
    Entry &entry = found->second;
    MtlMaterial &material = entry.material;
    if (!material.texture.empty() && !entry.has_texture_yet) {
        entry.has_texture_yet = true;
        const fs::path &file = files_[entry.file];
        Problems problems(file.string());
        material.material.texture =
            textures_.find(paths_.beside(file, kind), material.texture, material.texture_place.place(), problems);
        problems_.adopt(std::move(problems));
    }
    return material.material;
}

void MaterialLibraries::tell_of_missing(const std::string &name, const Place &place) {
    if (problems_.full()) return problems_.error(place, {});
    std::vector<std::string_view> known;
    if (materials_.size() <= most_to_compare) {
        for (const auto &[other, entry] : materials_) known.push_back(other);
    }
    const auto nearest = nearest_word(name, known);
    std::string hint;
    if (nearest) {
        hint = words("did you mean ", in_quotes(*nearest), '?');
    } else if (files_.empty()) {
        hint = "no line 'mtllib' names a library";
    } else if (name.find(" #") != std::string::npos) {
        hint = "a material's name goes to the end of the line, with all that follows a '#'";
    }
    problems_.error(place, words("there is no material ", in_quotes(name)), std::move(hint));
}

} // namespace glint
