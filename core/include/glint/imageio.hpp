// Writing pictures to image files, in the format that the file's extension names, and reading textures from them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glint/framebuffer.hpp>
#include <glint/renderer.hpp>
#include <glint/result.hpp>
#include <glint/scene.hpp>

namespace glint {

/// Extensions that write_image knows, lower case, without the dot: "png", "exr", ...
[[nodiscard]] std::vector<std::string> image_extensions();

/// Whether this file's format keeps linear floats (EXR, HDR) and so needs a framebuffer made with radiance.
/// False for unknown extensions.
[[nodiscard]] bool image_needs_radiance(const std::filesystem::path &file);

/// Says early, before minutes of rendering, what would keep write_image from writing `file`. Writes nothing.
/// Fails with bad_input when the extension is missing or unknown, unsupported when the image module or the library
/// behind it is not installed, io when the folder or the file cannot be written.
[[nodiscard]] Status check_image_file(const std::filesystem::path &file);

/// Writes the picture. 8-bit formats get the RGBA8 bytes as they are (RGB where the format has no alpha), float formats
/// the radiance; no curve and no colour conversion is applied to either.
///
/// The bytes go to a temporary file in the target's folder, reach the disk, and only then take the target's name: a
/// reader never sees half a picture, and nothing is left behind on failure. A symbolic link is followed. A target that
/// exists and is not a regular file (a device, a FIFO) is written into instead, as PNG when it has no extension.
///
/// Fails as check_image_file does, with io when the system refuses the bytes, and with cancelled when `control` says
/// so.
[[nodiscard]] Status write_image(const std::filesystem::path &file, const Framebuffer &picture,
                                 const RenderControl *control = nullptr);

/// Reads an image file as a texture, for ReadOptions::read_texture; what format it has, its contents say. The values
/// are taken as they are, without any curve: whole numbers as fractions of their largest one, floats cut off at 0
/// and 1. Grey becomes red, green and blue, alpha is left aside.
///
/// Fails, naming the file, with not_found when it is missing or not a regular file, bad_input when it is broken or of
/// an unknown format, limit_exceeded when it has more than 2^26 pixels, more than 2^20 a side or more than memory
/// holds, unsupported when the image module or the library behind it is not installed.
[[nodiscard]] Result<Texture> read_texture(const std::filesystem::path &file);

/// Name and version of the library behind the image module, e.g. "OpenImageIO 2.4.7.1". Fails with unsupported when it
/// is not installed.
[[nodiscard]] Result<std::string> image_library_version();

} // namespace glint
