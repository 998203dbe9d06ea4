// The meshes of one scene file, each read once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include <glint/read.hpp>

#include "mesh/texture_library.hpp"
#include "text/asset_paths.hpp"
#include "text/problems.hpp"
#include "text/text_file.hpp"

namespace glint {

/// Reads OBJ files on demand and remembers them, by what they are called and by what they are.
class MeshLibrary {
public:
    MeshLibrary(AssetPaths paths, const ReadOptions &options)
        : paths_(std::move(paths)), options_(options), textures_(options) {}

    /// A mesh, and the file it was found in.
    struct Found {
        std::shared_ptr<const Mesh> mesh; ///< nullptr where it cannot be had
        std::filesystem::path file;
    };

    /// The mesh that a scene calls `name` at `place`. Why it cannot be had is reported at the first use.
    [[nodiscard]] Found find(std::string_view name, const Place &place, Problems &problems);
    /// The mesh, which the scene calls `name`, moved by `offset`; nullptr, after an error, where that takes it beyond
    /// max_coordinate or leaves none of its triangles an area.
    [[nodiscard]] std::shared_ptr<const Mesh> moved(const std::shared_ptr<const Mesh> &mesh, const Vector &offset,
                                                    std::string_view name, const Place &place, Problems &problems);

    /// A mesh with its materials, and the file it was found in.
    struct FoundModel {
        std::shared_ptr<const ModelFile> model; ///< nullptr where it cannot be had
        std::filesystem::path file;
    };

    /// The model that a scene calls `name` at `place`. Why it cannot be had is reported at the first use. Models share
    /// their textures.
    [[nodiscard]] FoundModel find_model(std::string_view name, const Place &place, Problems &problems);

    [[nodiscard]] const AssetPaths &paths() const { return paths_; }
    /// Every file that was read, in order of first use.
    [[nodiscard]] std::vector<std::filesystem::path> take_files() { return std::move(files_); }

private:
    [[nodiscard]] Found look_up(const std::string &name, const Place &place, Problems &problems);
    [[nodiscard]] std::shared_ptr<const Mesh> read(const std::filesystem::path &path, const Place &place,
                                                   Problems &problems);
    [[nodiscard]] std::shared_ptr<const ModelFile> read_model(const std::filesystem::path &path, const Place &place,
                                                              Problems &problems);
    /// The text of an OBJ file, which is then one of files_.
    [[nodiscard]] std::optional<TextFile> open(const std::filesystem::path &path, const Place &place,
                                               Problems &problems);

    AssetPaths paths_;
    const ReadOptions &options_;
    /// A mesh of another file's, moved by x y z.
    using Move = std::tuple<const Mesh *, float, float, float>;

    std::unordered_map<std::string, Found> by_name_;
    std::map<Move, std::shared_ptr<const Mesh>> moved_;
    std::map<std::filesystem::path, std::shared_ptr<const Mesh>> by_file_; ///< keys without symbolic links
    std::unordered_map<std::string, FoundModel> models_by_name_;
    std::map<std::filesystem::path, std::shared_ptr<const ModelFile>> models_by_file_; ///< likewise
    TextureLibrary textures_;
    std::vector<std::filesystem::path> files_;
};

} // namespace glint
