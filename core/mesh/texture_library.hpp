// The textures that materials name, each read once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include <glint/read.hpp>

#include "text/asset_paths.hpp"
#include "text/problems.hpp"

namespace glint {

/// Reads textures on demand, through the caller's hook, and remembers them by what they are.
class TextureLibrary {
public:
    explicit TextureLibrary(const ReadOptions &options) : options_(options) {}

    /// The texture that a file calls `name` at `place`; nullptr where it cannot be had, after an error, and where
    /// textures are left aside, after a warning at the first.
    [[nodiscard]] std::shared_ptr<const Texture> find(const AssetPaths &paths, std::string_view name,
                                                      const Place &place, Problems &problems);

    /// Every file that was read, in order of first use.
    [[nodiscard]] const std::vector<std::filesystem::path> &files() const { return files_; }

private:
    [[nodiscard]] Result<Texture> read(const std::filesystem::path &file) const;

    const ReadOptions &options_;
    std::map<std::filesystem::path, std::shared_ptr<const Texture>> by_file_; ///< keys without symbolic links
    std::vector<std::filesystem::path> files_;
    bool told_of_no_reader_ = false;
};

} // namespace glint
