// Putting bytes into a file so that the file is never seen half written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include <glint/renderer.hpp>
#include <glint/result.hpp>

namespace glint::imageio {

/// Fails with io when `file` is a folder, its folder is missing, or the system would refuse to write there.
[[nodiscard]] Status check_target(const std::filesystem::path &file);

/// Makes `bytes` the content of `file`: through a temporary file beside it that is renamed once the bytes are on the
/// disk, or by writing into it when it exists and is not a regular file. Symbolic links are followed; an existing
/// file's permissions are kept. Fails with io and the system's own words, or with cancelled when `control` (may be
/// nullptr) says so before the bytes have the file's name. No temporary file outlives the call.
[[nodiscard]] Status replace_file(const std::filesystem::path &file, std::span<const uint8_t> bytes,
                                  const RenderControl *control);

} // namespace glint::imageio
