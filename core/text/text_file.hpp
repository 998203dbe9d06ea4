// Reading a whole text file without trusting what its name leads to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include <glint/result.hpp>

namespace glint {

/// A file's bytes, writable in place.
struct TextFile {
    std::unique_ptr<char[]> bytes;
    size_t size = 0;

    [[nodiscard]] std::string_view view() const { return {bytes.get(), size}; }
};

/// Reads a regular file. Folders, pipes, sockets and devices are refused without being opened, so that none of them can
/// block or have an effect. Fails with one diagnostic, which names no file (the caller knows what the user called it):
/// not_found, limit_exceeded (more than max_bytes, or than memory) or io.
[[nodiscard]] Result<TextFile> read_text_file(const std::filesystem::path &path, uint64_t max_bytes);

} // namespace glint
