// How a scene file calls the files it names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <glint/result.hpp>

#include "text/files.hpp"

namespace glint {

/// Names of files for a scene file that lies in a certain folder: relative to it, with '/', and such that the reader
/// takes them for one word.
class FileNames {
public:
    /// Fails where the folder is not there.
    [[nodiscard]] static Result<FileNames> in_folder(const Files &files, const std::filesystem::path &folder);

    /// The name of a file that exists. Fails, with one diagnostic that names no file, where an SDL file has no way to
    /// write it.
    [[nodiscard]] Result<std::string> name_of(const std::filesystem::path &file);

    /// Takes note of a name that stays as it is.
    void keep(const std::string &name);

    /// The innermost folder that holds every file named so far, where that is not the scene file's own.
    [[nodiscard]] std::optional<std::filesystem::path> scene_root() const;

private:
    FileNames(const Files &files, std::filesystem::path folder)
        : files_(files), folder_(std::move(folder)), root_(folder_) {}
    /// Of what exists. Throws std::filesystem::filesystem_error.
    [[nodiscard]] std::filesystem::path real_path(const std::filesystem::path &path) const;
    void reach(const std::filesystem::path &file);

    Files files_;
    std::filesystem::path folder_; ///< as Files::real() says, as is root_
    std::filesystem::path root_;
};

} // namespace glint
