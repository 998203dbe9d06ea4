// Where the files that a scene names are looked for, and where they may not be.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glint/read.hpp>

#include "text/files.hpp"

namespace glint {

/// Looks for files in the folder of the file that names them, then in each folder above it up to the scene root. What
/// lies outside the root - by "..", by an absolute path or through a symbolic link - is refused unless the caller
/// allowed it.
class AssetPaths {
public:
    /// Fails where the scene root does not exist or does not hold the scene file.
    [[nodiscard]] static Result<AssetPaths> create(const std::filesystem::path &scene_file, const ReadOptions &options);

    [[nodiscard]] const Files &files() const { return files_; }

    /// The same root, for the names in another file that was found in it. `kind` is what messages call that file.
    [[nodiscard]] AssetPaths beside(const std::filesystem::path &file, std::string_view kind) const;

    /// The file that `name` stands for; it exists, and may still be a folder. Fails, with one diagnostic that names no
    /// file, where the name leaves the root or leads nowhere: then every place that was tried is in the hint, and the
    /// scene root that would let it be found, if there is one.
    [[nodiscard]] Result<std::filesystem::path> find(std::string_view name) const;

    /// Why a scene may not ask for its picture to be written to `name`, or nothing.
    [[nodiscard]] std::optional<std::string> output_problem(std::string_view name) const;

private:
    struct Folder {
        std::filesystem::path shown; ///< as the user wrote it, where the user did
        std::filesystem::path real;  ///< as Files::real() says, as is root_
    };

    explicit AssetPaths(const Files &files) : files_(files) {}
    void look_from(const std::filesystem::path &shown, std::filesystem::path real);
    [[nodiscard]] bool holds(const std::filesystem::path &real) const;
    [[nodiscard]] std::string outside_message(std::string_view name) const;
    [[nodiscard]] std::string wider_root_hint(const std::filesystem::path &relative) const;

    Files files_;
    std::vector<Folder> folders_; ///< in the order of looking
    std::filesystem::path root_;
    std::string kind_ = "scene file"; ///< of file that names others
    bool allow_outside_root_ = false;
};

} // namespace glint
