// The place that readers' files lie in: the system's file system, or a source that the caller gave.
#pragma once

#include <filesystem>
#include <system_error>

#include <glint/file_source.hpp>

#include "text/text_file.hpp"

namespace glint {

/// What readers ask of it. In a source, a path is what its letters say: there are no links, and every folder exists.
class Files {
public:
    /// `source` must outlive this; nullptr = the system.
    explicit Files(const FileSource *source = nullptr) : source_(source) {}

    [[nodiscard]] bool are_of_system() const { return !source_; }

    /// The path's one name, absolute and without symbolic links; fails where there is no such thing.
    [[nodiscard]] std::filesystem::path real(const std::filesystem::path &path, std::error_code &problem) const;
    /// The same of a path whose end need not exist.
    [[nodiscard]] std::filesystem::path nearly_real(const std::filesystem::path &path, std::error_code &problem) const;

    [[nodiscard]] bool is_folder(const std::filesystem::path &path) const;
    [[nodiscard]] bool is_file(const std::filesystem::path &path) const;
    /// Whether there is anything of the name; true also where the system does not tell.
    [[nodiscard]] bool may_exist(const std::filesystem::path &path) const;

    /// As read_text_file() and FileSource::read() do.
    [[nodiscard]] Result<TextFile> read(const std::filesystem::path &path, uint64_t max_bytes) const;

private:
    const FileSource *source_;
};

} // namespace glint
