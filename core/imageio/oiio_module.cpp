// The image module: encodes pictures into memory with OpenImageIO. The only file that knows OpenImageIO.
#include "imageio/module_abi.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <glint/export.hpp>

namespace {

using Picture = glint_imageio_picture;

OIIO::TypeDesc sample_type(const Picture &picture) {
    return picture.is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
}

OIIO::ImageSpec spec_of(const Picture &picture) {
    OIIO::ImageSpec spec(static_cast<int>(picture.width_px), static_cast<int>(picture.height_px),
                         static_cast<int>(picture.channels), sample_type(picture));
    // The numbers are to arrive as they are: no division by alpha.
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

struct Failure {
    std::string message;
};

/// Returns false when the caller stopped it.
bool encode(const Picture &picture, std::vector<unsigned char> &file) {
    OIIO::Filesystem::IOVecOutput memory(file); // outlives `output`, whose destructor may still write
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(picture.format);
    if (!output) throw Failure{OIIO::geterror()};
    if (!output->supports("ioproxy")) {
        throw Failure{std::string("this OpenImageIO cannot encode ") + picture.format + " into memory"};
    }
    output->set_ioproxy(&memory);
    if (!output->open(std::string("picture.") + picture.format, spec_of(picture))) throw Failure{output->geterror()};

    // In bands of whole strips and blocks of every format, so that a caller who stops is heard in between.
    constexpr uint32_t band_rows = 64;
    const auto row_stride = static_cast<OIIO::stride_t>(picture.row_stride_bytes);
    for (uint32_t y = 0; y < picture.height_px; y += band_rows) {
        // Not before the first band: libpng complains on standard error about a file without any pixels.
        if (y > 0 && picture.stop && picture.stop(picture.stop_context) != 0) return false;
        const uint32_t end = std::min(y + band_rows, picture.height_px);
        const auto *const row = static_cast<const uint8_t *>(picture.samples) + y * picture.row_stride_bytes;
        if (!output->write_scanlines(static_cast<int>(y), static_cast<int>(end), 0, sample_type(picture), row,
                                     static_cast<OIIO::stride_t>(picture.pixel_stride_bytes), row_stride)) {
            throw Failure{output->geterror()};
        }
    }
    if (!output->close()) throw Failure{output->geterror()};
    return true;
}

void say(char *message, size_t message_bytes, const std::string &text) noexcept {
    std::snprintf(message, message_bytes, "%s", text.empty() ? "OpenImageIO gave no reason" : text.c_str());
}

} // namespace

extern "C" {

GLINT_API uint32_t glint_imageio_abi(void) {
    return GLINT_IMAGEIO_ABI;
}

GLINT_API const char *glint_imageio_library(void) {
    // The version that is loaded, which may be newer than the headers.
    static const std::string name = [] {
        const int version = OIIO::openimageio_version();
        return "OpenImageIO " + std::to_string(version / 10000) + '.' + std::to_string(version / 100 % 100) + '.' +
               std::to_string(version % 100);
    }();
    return name.c_str();
}

GLINT_API int glint_imageio_encode(const glint_imageio_picture *picture, glint_imageio_bytes *file, char *message,
                                   size_t message_bytes) {
    *file = {};
    try {
        auto bytes = std::make_unique<std::vector<unsigned char>>();
        if (!encode(*picture, *bytes)) return GLINT_IMAGEIO_STOPPED;
        *file = {bytes->data(), bytes->size(), bytes.get()};
        static_cast<void>(bytes.release());
        return GLINT_IMAGEIO_OK;
    } catch (const Failure &failure) {
        say(message, message_bytes, failure.message);
    } catch (const std::exception &error) {
        std::snprintf(message, message_bytes, "%s", error.what());
    } catch (...) {
        std::snprintf(message, message_bytes, "an unknown failure");
    }
    return GLINT_IMAGEIO_FAILED;
}

GLINT_API void glint_imageio_release(glint_imageio_bytes *file) {
    delete static_cast<std::vector<unsigned char> *>(file->owner);
    *file = {};
}

} // extern "C"
