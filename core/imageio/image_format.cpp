// Which file formats are written, under which extensions, and what goes into them.
#include "imageio/image_format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <system_error>

namespace glint::imageio {
namespace {

// Alpha only where every reader of the format expects it; elsewhere it would be 255 throughout and a surprise.
constexpr std::array formats{
    ImageFormat{"png", "png", Content::rgba8},        ImageFormat{"jpg", "jpeg", Content::rgb8},
    ImageFormat{"jpeg", "jpeg", Content::rgb8},       ImageFormat{"ppm", "pnm", Content::rgb8},
    ImageFormat{"pnm", "pnm", Content::rgb8},         ImageFormat{"bmp", "bmp", Content::rgb8},
    ImageFormat{"tga", "targa", Content::rgb8},       ImageFormat{"tif", "tiff", Content::rgba8},
    ImageFormat{"tiff", "tiff", Content::rgba8},      ImageFormat{"webp", "webp", Content::rgb8},
    ImageFormat{"exr", "openexr", Content::radiance}, ImageFormat{"hdr", "hdr", Content::radiance},
};

std::string lower_extension(const std::filesystem::path &file) {
    std::string extension = file.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::string known_extensions() {
    std::string list;
    for (const ImageFormat &format : formats) {
        if (!list.empty()) list += ", ";
        list += format.extension;
    }
    return list;
}

} // namespace

std::span<const ImageFormat> image_formats() {
    return formats;
}

const ImageFormat *find_format(const std::filesystem::path &file) {
    const std::string extension = lower_extension(file);
    const auto found = std::find_if(formats.begin(), formats.end(),
                                    [&](const ImageFormat &format) { return format.extension == extension; });
    return found == formats.end() ? nullptr : &*found;
}

Result<ImageFormat> choose_format(const std::filesystem::path &file) {
    if (const ImageFormat *format = find_format(file)) return *format;
    const std::string extension = lower_extension(file);
    if (extension.empty()) {
        std::error_code ignored;
        const std::filesystem::file_status status = std::filesystem::status(file, ignored);
        if (std::filesystem::is_other(status)) return formats.front();
    }
    const std::string found = extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'";
    return Error(ErrorCode::bad_input, "the image file '" + file.string() + "' " + found,
                 "known extensions: " + known_extensions());
}

} // namespace glint::imageio
