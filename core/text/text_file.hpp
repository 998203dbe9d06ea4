// Reading a whole text file without trusting what its name leads to.
#pragma once

#include <cstdint>
#include <filesystem>

#include <glint/file_source.hpp>
#include <glint/result.hpp>

namespace glint {

/// A file's bytes, writable in place.
using TextFile = FileBytes;

/// Reads a regular file. Folders, pipes, sockets and devices are refused without being opened, so that none of them can
/// block or have an effect. Fails with one diagnostic, which names no file (the caller knows what the user called it):
/// not_found, limit_exceeded (more than max_bytes), out_of_memory or io.
[[nodiscard]] Result<TextFile> read_text_file(const std::filesystem::path &path, uint64_t max_bytes);

/// What reading more than max_bytes fails with.
[[nodiscard]] Error file_too_large(uint64_t size_bytes, uint64_t max_bytes);

} // namespace glint
