// A framebuffer's way into a file: choose the format, have the module encode it, replace the file.
#include <glint/imageio.hpp>

#include <array>
#include <span>

#include "imageio/file_target.hpp"
#include "imageio/image_format.hpp"
#include "imageio/module.hpp"

namespace glint {
namespace {

using imageio::Content;
using imageio::ImageFormat;
using imageio::Module;

/// A file's bytes, given back to the module at the end of the scope.
class EncodedFile {
public:
    explicit EncodedFile(const Module &module) : module_(module) {}
    ~EncodedFile() { module_.release(&bytes_); }
    EncodedFile(const EncodedFile &) = delete;
    EncodedFile &operator=(const EncodedFile &) = delete;

    [[nodiscard]] glint_imageio_bytes *target() { return &bytes_; }
    [[nodiscard]] std::span<const uint8_t> bytes() const { return {bytes_.data, bytes_.count}; }

private:
    const Module &module_;
    glint_imageio_bytes bytes_{};
};

int stop_when_cancelled(void *control) {
    return static_cast<const RenderControl *>(control)->cancelled();
}

glint_imageio_picture describe(const Framebuffer &picture, const ImageFormat &format) {
    glint_imageio_picture description{};
    description.format = format.oiio_name.data(); // the table's views are of literals, which end in zero
    description.width_px = picture.width_px();
    description.height_px = picture.height_px();
    description.channels = format.content == Content::rgba8 ? 4 : 3;
    if (format.content == Content::radiance) {
        description.is_float = 1;
        description.samples = picture.radiance();
        description.pixel_stride_bytes = 3 * sizeof(float);
        description.row_stride_bytes = picture.radiance_stride_bytes();
    } else {
        description.samples = picture.rgba8();
        description.pixel_stride_bytes = 4;
        description.row_stride_bytes = picture.rgba8_stride_bytes();
    }
    return description;
}

} // namespace

std::vector<std::string> image_extensions() {
    std::vector<std::string> extensions;
    for (const ImageFormat &format : imageio::image_formats()) extensions.emplace_back(format.extension);
    return extensions;
}

bool image_needs_radiance(const std::filesystem::path &file) {
    const ImageFormat *format = imageio::find_format(file);
    return format && format->content == Content::radiance;
}

Status check_image_file(const std::filesystem::path &file) {
    if (Result<ImageFormat> format = imageio::choose_format(file); !format) return format.error();
    if (Status target = imageio::check_target(file); !target) return target;
    if (Result<Module> module = imageio::load_module(); !module) return module.error();
    return Done{};
}

Status write_image(const std::filesystem::path &file, const Framebuffer &picture, const RenderControl *control) {
    const Result<ImageFormat> format = imageio::choose_format(file);
    if (!format) return format.error();
    if (format->content == Content::radiance && !picture.has_radiance()) {
        return Error(ErrorCode::unsupported,
                     "'" + file.string() + "' keeps radiance, but the picture was rendered without");
    }
    const Result<Module> module = imageio::load_module();
    if (!module) return module.error();
    if (control && control->cancelled()) return Error(ErrorCode::cancelled, "writing was cancelled");

    glint_imageio_picture description = describe(picture, *format);
    if (control) {
        description.stop = &stop_when_cancelled;
        description.stop_context = const_cast<RenderControl *>(control); // only read
    }
    EncodedFile encoded(*module);
    std::array<char, 512> message{};
    switch (module->encode(&description, encoded.target(), message.data(), message.size())) {
    case GLINT_IMAGEIO_OK:
        return imageio::replace_file(file, encoded.bytes(), control);
    case GLINT_IMAGEIO_STOPPED:
        return Error(ErrorCode::cancelled, "writing was cancelled");
    default:
        return Error(ErrorCode::io, "cannot encode '" + file.string() + "': " + message.data());
    }
}

Result<std::string> image_library_version() {
    const Result<Module> module = imageio::load_module();
    if (!module) return module.error();
    return std::string(module->library());
}

} // namespace glint
