// The textures that materials name, each read once.
#include "mesh/texture_library.hpp"

#include <optional>
#include <utility>

#include "text/asset_file.hpp"
#include "text/folders.hpp"
#include "text/words.hpp"

namespace glint {

std::shared_ptr<const Texture> TextureLibrary::find(const AssetPaths &paths, std::string_view name, const Place &place,
                                                    Problems &problems) {
    const std::optional<std::filesystem::path> file = find_asset(paths, name, place, problems);
    if (!file) return nullptr;
    const bool is_read = options_.files ? bool(options_.decode_texture) : bool(options_.read_texture);
    if (!is_read) {
        if (!told_of_no_reader_) {
            problems.warn(place, words("the texture ", in_quotes(name), " is left aside, and so are all others"),
                          "this program reads no image files");
        }
        told_of_no_reader_ = true;
        return nullptr;
    }
    const auto [entry, is_new] = by_file_.try_emplace(real_path(paths.files(), *file));
    if (!is_new) return entry->second;
    Result<Texture> texture = read(*file);
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

Result<Texture> TextureLibrary::read(const std::filesystem::path &file) const {
    if (!options_.files) return options_.read_texture(file);
    const auto about_it = [&](Error error) {
        for (Diagnostic &diagnostic : error.diagnostics) {
            diagnostic.message = words("texture ", path_in_quotes(file.string()), ": ", diagnostic.message);
        }
        return error;
    };
    const Result<TextFile> bytes = Files(options_.files.get()).read(file, options_.max_file_bytes);
    if (!bytes.ok()) return about_it(bytes.error());
    Result<Texture> texture = options_.decode_texture(bytes->view(), plain_path(file).generic_string());
    if (!texture.ok()) return about_it(std::move(texture).error());
    return texture;
}

} // namespace glint
