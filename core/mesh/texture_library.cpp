// The textures that materials name, each read once.
#include "mesh/texture_library.hpp"

#include <optional>
#include <utility>

#include "text/asset_file.hpp"
#include "text/words.hpp"

namespace glint {

std::shared_ptr<const Texture> TextureLibrary::find(const AssetPaths &paths, std::string_view name, const Place &place,
                                                    Problems &problems) {
    const std::optional<std::filesystem::path> file = find_asset(paths, name, place, problems);
    if (!file) return nullptr;
    if (!options_.read_texture) {
        if (!told_of_no_reader_) {
            problems.warn(place, words("the texture ", in_quotes(name), " is left aside, and so are all others"),
                          "this program reads no image files");
        }
        told_of_no_reader_ = true;
        return nullptr;
    }
    const auto [entry, is_new] = by_file_.try_emplace(real_path(*file));
    if (!is_new) return entry->second;
    Result<Texture> texture = options_.read_texture(*file);
    if (texture.ok()) {
        files_.push_back(*file);
        entry->second = std::make_shared<const Texture>(std::move(texture).value());
        return entry->second;
    }
    for (const Diagnostic &diagnostic : texture.error().diagnostics) {
        problems.error(place, diagnostic.message, diagnostic.hint, texture.error().code);
    }
    return nullptr;
}

} // namespace glint
