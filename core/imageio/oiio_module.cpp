// The image module: encodes pictures into memory, and decodes files, with OpenImageIO. The only file that knows
// OpenImageIO.
#include "imageio/module_abi.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>
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

/// "Readers" that look into no picture file: one makes pictures of nothing, one listens to the network, one draws on
/// the terminal, one plays films.
bool reads_pictures(const std::string &format) {
    for (const char *other : {"null", "socket", "term", "ffmpeg"}) {
        if (format == other) return false;
    }
    return true;
}

/// Channels that are read: one for grey, perhaps with alpha, else three.
int wanted_channels(const OIIO::ImageSpec &spec) {
    return spec.nchannels < 3 ? 1 : 3;
}

void read_samples(OIIO::ImageInput &input, const OIIO::ImageSpec &spec, OIIO::TypeDesc type, void *samples,
                  size_t pixel_bytes) {
    const auto pixel_stride = static_cast<OIIO::stride_t>(pixel_bytes);
    const bool is_read = input.read_image(0, 0, 0, wanted_channels(spec), type, samples, pixel_stride,
                                          pixel_stride * static_cast<OIIO::stride_t>(spec.width));
    // Of a TIFF that is cut off it returns true, with an error.
    if (!is_read || input.has_error()) throw Failure{input.geterror()};
}

/// Divides by itself: the library multiplies by a reciprocal, and some values end up a rounding away.
template <typename Whole> void decode_whole_numbers(OIIO::ImageInput &input, const OIIO::ImageSpec &spec, float *rgb) {
    const auto channels = static_cast<size_t>(wanted_channels(spec));
    const size_t pixels = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height);
    std::vector<Whole> samples(channels * pixels);
    read_samples(input, spec, OIIO::BaseTypeFromC<Whole>::value, samples.data(), channels * sizeof(Whole));
    const auto largest = static_cast<float>(std::numeric_limits<Whole>::max());
    for (size_t i = 0; i < 3 * pixels; ++i) {
        rgb[i] = static_cast<float>(samples[channels == 3 ? i : i / 3]) / largest;
    }
}

void decode_floats(OIIO::ImageInput &input, const OIIO::ImageSpec &spec, float *rgb) {
    const size_t values = size_t{3} * static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height);
    read_samples(input, spec, OIIO::TypeDesc::FLOAT, rgb, 3 * sizeof(float));
    if (wanted_channels(spec) == 3) return;
    for (size_t i = 0; i < values; i += 3) rgb[i + 1] = rgb[i + 2] = rgb[i];
}

/// Returns false when the caller had no room.
bool decode(const char *file, const glint_imageio_room &room) {
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(file);
    if (!input) throw Failure{OIIO::geterror()};
    if (!reads_pictures(input->format_name())) throw Failure{"it is no picture"};
    OIIO::ImageSpec as_it_is, spec;
    as_it_is.attribute("oiio:UnassociatedAlpha", 1); // no multiplication by alpha
    if (!input->open(file, spec, as_it_is)) throw Failure{input->geterror()};
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.deep) {
        throw Failure{"it is no flat picture"};
    }
    const auto width = static_cast<uint32_t>(spec.width), height = static_cast<uint32_t>(spec.height);
    float *const rgb = room.ask(room.context, width, height);
    if (!rgb) return false;

    if (spec.format == OIIO::TypeDesc::UINT8) {
        decode_whole_numbers<uint8_t>(*input, spec, rgb);
    } else if (spec.format == OIIO::TypeDesc::UINT16) {
        decode_whole_numbers<uint16_t>(*input, spec, rgb);
    } else {
        decode_floats(*input, spec, rgb);
    }
    return true;
}

/// Does the work, which returns whether it was not stopped. No exception leaves the module.
template <typename Work> int outcome_of(Work &&work, char *message, size_t message_bytes) noexcept {
    const auto say = [&](const char *text) { std::snprintf(message, message_bytes, "%s", text); };
    try {
        return work() ? GLINT_IMAGEIO_OK : GLINT_IMAGEIO_STOPPED;
    } catch (const Failure &failure) {
        say(failure.message.empty() ? "OpenImageIO gave no reason" : failure.message.c_str());
    } catch (const std::exception &error) {
        say(error.what());
    } catch (...) {
        say("an unknown failure");
    }
    return GLINT_IMAGEIO_FAILED;
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
    return outcome_of(
        [&] {
            auto bytes = std::make_unique<std::vector<unsigned char>>();
            if (!encode(*picture, *bytes)) return false;
            *file = {bytes->data(), bytes->size(), bytes.get()};
            static_cast<void>(bytes.release());
            return true;
        },
        message, message_bytes);
}

GLINT_API int glint_imageio_decode(const char *file, const glint_imageio_room *room, char *message,
                                   size_t message_bytes) {
    return outcome_of([&] { return decode(file, *room); }, message, message_bytes);
}

GLINT_API void glint_imageio_release(glint_imageio_bytes *file) {
    delete static_cast<std::vector<unsigned char> *>(file->owner);
    *file = {};
}

} // extern "C"
