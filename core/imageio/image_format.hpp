// Which file formats are written, under which extensions, and what goes into them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include <glint/result.hpp>

namespace glint::imageio {

/// What a format stores of a picture.
enum class Content {
    rgb8,     ///< the 8-bit picture without its alpha
    rgba8,    ///< the 8-bit picture
    radiance, ///< the linear floats
};

struct ImageFormat {
    std::string_view extension; ///< lower case, without the dot
    std::string_view oiio_name; ///< OpenImageIO's name of the format
    Content content;
};

/// Every format, the usual ones first.
[[nodiscard]] std::span<const ImageFormat> image_formats();

/// The format that the file's extension names (upper or lower case); nullptr when it names none.
[[nodiscard]] const ImageFormat *find_format(const std::filesystem::path &file);

/// As find_format, and PNG for a device or FIFO without an extension; fails with bad_input, naming the known
/// extensions.
[[nodiscard]] Result<ImageFormat> choose_format(const std::filesystem::path &file);

} // namespace glint::imageio
