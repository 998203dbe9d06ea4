// Pictures read back from their files are the pictures that were written.
#include <glint/imageio.hpp>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "imageio/image_format.hpp"
#include "imageio/module.hpp"

#include "imageio/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace glint {
namespace {

using WriteImage = test::TemporaryFolder;

constexpr uint32_t small_width = 37, small_height = 23; // no power of two, no multiple of anything

/// Every byte value, every alpha, and floats on both sides of what a display shows.
Framebuffer noisy_picture(bool with_radiance = true, uint32_t width = small_width, uint32_t height = small_height) {
    Framebuffer picture = Framebuffer::create(width, height, with_radiance).value();
    uint32_t state = 12345;
    const auto next = [&] { return state = state * 1664525u + 1013904223u, state >> 16; };
    for (size_t i = 0; i < picture.rgba8_stride_bytes() * height; ++i)
        picture.rgba8()[i] = static_cast<uint8_t>(next());
    for (size_t i = 0; with_radiance && i < size_t{3} * width * height; ++i) {
        picture.radiance()[i] = 4.0f * static_cast<float>(next()) / 65536.0f + 1e-3f;
    }
    return picture;
}

struct ReadBack {
    OIIO::ImageSpec spec;
    std::vector<uint8_t> bytes;
    std::vector<float> floats;
};

/// The file's own numbers, without any conversion.
ReadBack read_back(const fs::path &file) {
    OIIO::ImageSpec keep_alpha;
    keep_alpha.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file.string(), &keep_alpha);
    EXPECT_TRUE(input) << OIIO::geterror();
    if (!input) return {};
    ReadBack result{input->spec(), {}, {}};
    const size_t count = static_cast<size_t>(result.spec.width) * static_cast<size_t>(result.spec.height) *
                         static_cast<size_t>(result.spec.nchannels);
    result.bytes.resize(count);
    result.floats.resize(count);
    EXPECT_TRUE(input->read_image(0, 0, 0, result.spec.nchannels, OIIO::TypeDesc::UINT8, result.bytes.data()));
    EXPECT_TRUE(input->read_image(0, 0, 0, result.spec.nchannels, OIIO::TypeDesc::FLOAT, result.floats.data()));
    return result;
}

std::vector<uint8_t> rgba_of(const Framebuffer &picture) {
    return {picture.rgba8(), picture.rgba8() + picture.rgba8_stride_bytes() * picture.height_px()};
}

std::vector<uint8_t> rgb_of(const Framebuffer &picture) {
    std::vector<uint8_t> rgb;
    for (const std::vector<uint8_t> rgba = rgba_of(picture); const uint8_t &byte : rgba) {
        if ((&byte - rgba.data()) % 4 != 3) rgb.push_back(byte);
    }
    return rgb;
}

TEST_F(WriteImage, png_and_tiff_hold_exactly_the_rgba_bytes) {
    const Framebuffer picture = noisy_picture();
    for (const char *name : {"a.png", "a.tif", "a.tiff"}) {
        const Status written = write_image(in_folder(name), picture);
        ASSERT_TRUE(written.ok()) << written.error().text();
        const ReadBack file = read_back(in_folder(name));
        EXPECT_EQ(file.spec.width, static_cast<int>(small_width)) << name;
        EXPECT_EQ(file.spec.height, static_cast<int>(small_height)) << name;
        EXPECT_EQ(file.spec.format, OIIO::TypeDesc::UINT8) << name;
        EXPECT_EQ(file.bytes, rgba_of(picture)) << name;
    }
}

TEST_F(WriteImage, ppm_bmp_and_tga_hold_exactly_the_rgb_bytes) {
    const Framebuffer picture = noisy_picture();
    for (const char *name : {"a.ppm", "a.pnm", "a.bmp", "a.tga"}) {
        const Status written = write_image(in_folder(name), picture);
        ASSERT_TRUE(written.ok()) << written.error().text();
        const ReadBack file = read_back(in_folder(name));
        EXPECT_EQ(file.spec.nchannels, 3) << name;
        EXPECT_EQ(file.bytes, rgb_of(picture)) << name;
    }
}

TEST_F(WriteImage, exr_holds_exactly_the_radiance_bits) {
    const Framebuffer picture = noisy_picture();
    ASSERT_TRUE(write_image(in_folder("a.exr"), picture).ok());
    const ReadBack file = read_back(in_folder("a.exr"));
    EXPECT_EQ(file.spec.format, OIIO::TypeDesc::FLOAT);
    ASSERT_EQ(file.floats.size(), size_t{3} * small_width * small_height);
    EXPECT_EQ(std::memcmp(file.floats.data(), picture.radiance(), file.floats.size() * sizeof(float)), 0);
}

TEST_F(WriteImage, leaves_out_what_lies_between_rows) {
    const Framebuffer picture = noisy_picture();
    constexpr size_t stride = small_width * 4 + 20, light_stride = small_width * 3 + 5; // bytes and floats
    std::vector<uint8_t> bytes(stride * small_height, 77);
    std::vector<float> light(light_stride * small_height, 77.0f);
    for (size_t y = 0; y < small_height; ++y) {
        std::copy_n(picture.rgba8() + y * small_width * 4, small_width * 4, bytes.data() + y * stride);
        std::copy_n(picture.radiance() + y * small_width * 3, small_width * 3, light.data() + y * light_stride);
    }
    const auto wrapped =
        Framebuffer::wrap(small_width, small_height, bytes.data(), stride, light.data(), light_stride * sizeof(float));
    ASSERT_TRUE(wrapped.ok());
    for (const char *name : {"a.png", "a.bmp"}) {
        ASSERT_TRUE(write_image(in_folder(name), *wrapped).ok());
        EXPECT_EQ(read_back(in_folder(name)).bytes, name[2] == 'p' ? rgba_of(picture) : rgb_of(picture)) << name;
    }
    ASSERT_TRUE(write_image(in_folder("a.exr"), *wrapped).ok());
    const ReadBack file = read_back(in_folder("a.exr"));
    ASSERT_EQ(file.floats.size(), size_t{3} * small_width * small_height);
    EXPECT_EQ(std::memcmp(file.floats.data(), picture.radiance(), file.floats.size() * sizeof(float)), 0);
}

TEST_F(WriteImage, hdr_holds_the_radiance_to_the_precision_of_its_shared_exponent) {
    const Framebuffer picture = noisy_picture();
    ASSERT_TRUE(write_image(in_folder("a.hdr"), picture).ok());
    const ReadBack file = read_back(in_folder("a.hdr"));
    ASSERT_EQ(file.floats.size(), size_t{3} * small_width * small_height);
    for (size_t pixel = 0; pixel < file.floats.size(); pixel += 3) {
        const float *const want = picture.radiance() + pixel;
        const float step = std::max({want[0], want[1], want[2]}) / 128.0f; // eight bits of mantissa
        for (size_t c = 0; c < 3; ++c) ASSERT_NEAR(file.floats[pixel + c], want[c], step) << "pixel " << pixel / 3;
    }
}

TEST_F(WriteImage, jpeg_and_webp_look_like_a_smooth_picture) {
    Framebuffer picture = Framebuffer::create(64, 64, false).value();
    for (uint32_t i = 0; i < 64 * 64; ++i) {
        uint8_t *const pixel = picture.rgba8() + size_t{4} * i;
        pixel[0] = static_cast<uint8_t>(2 * (i % 64) + 40), pixel[1] = static_cast<uint8_t>(3 * (i / 64)),
        pixel[2] = 90;
        pixel[3] = 255;
    }
    for (const char *name : {"a.jpg", "a.jpeg", "a.webp"}) {
        const Status written = write_image(in_folder(name), picture);
        ASSERT_TRUE(written.ok()) << written.error().text();
        const ReadBack file = read_back(in_folder(name));
        const std::vector<uint8_t> want = rgb_of(picture);
        ASSERT_EQ(file.bytes.size(), want.size()) << name;
        for (size_t i = 0; i < want.size(); ++i) ASSERT_NEAR(file.bytes[i], want[i], 12) << name << ", byte " << i;
    }
}

TEST_F(WriteImage, every_listed_extension_can_be_written_and_passes_the_check) {
    const Framebuffer picture = noisy_picture();
    for (const std::string &extension : image_extensions()) {
        const fs::path file = in_folder("picture." + extension);
        EXPECT_TRUE(check_image_file(file).ok()) << extension;
        const Status written = write_image(file, picture);
        EXPECT_TRUE(written.ok()) << extension << ": " << written.error().text();
    }
    EXPECT_EQ(listing().size(), image_extensions().size());
}

TEST_F(WriteImage, no_colour_space_or_gamma_is_claimed_in_a_png) {
    ASSERT_TRUE(write_image(in_folder("a.png"), noisy_picture()).ok());
    std::FILE *const in = std::fopen(in_folder("a.png").c_str(), "rb");
    ASSERT_NE(in, nullptr);
    std::string start(200, '\0');
    start.resize(std::fread(start.data(), 1, start.size(), in));
    std::fclose(in);
    for (const char *chunk : {"gAMA", "sRGB", "iCCP"}) EXPECT_EQ(start.find(chunk), std::string::npos) << chunk;
}

TEST_F(WriteImage, float_formats_need_a_picture_with_radiance) {
    const Status written = write_image(in_folder("a.exr"), noisy_picture(/*with_radiance=*/false));
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::unsupported);
    EXPECT_TRUE(listing().empty());
}

TEST_F(WriteImage, every_encoder_can_be_stopped_half_way_without_a_sound) {
    constexpr uint32_t side = 1024;
    const Framebuffer picture = noisy_picture(/*with_radiance=*/false, side, side);
    const imageio::Module module = imageio::load_module().value();
    for (const imageio::ImageFormat &format : imageio::image_formats()) {
        glint_imageio_picture description{};
        description.format = format.oiio_name.data();
        description.width_px = description.height_px = side;
        description.channels = 3;
        description.samples = picture.rgba8();
        description.pixel_stride_bytes = 4;
        description.row_stride_bytes = picture.rgba8_stride_bytes();
        int questions = 0;
        description.stop = [](void *context) { return ++*static_cast<int *>(context) == 3 ? 1 : 0; };
        description.stop_context = &questions;

        glint_imageio_bytes file{};
        char message[200] = "";
        ::testing::internal::CaptureStderr();
        EXPECT_EQ(module.encode(&description, &file, message, sizeof message), GLINT_IMAGEIO_STOPPED)
            << format.extension << ": " << message;
        EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << format.extension;
        EXPECT_EQ(questions, 3) << format.extension;
        EXPECT_EQ(file.owner, nullptr);
    }
}

TEST_F(WriteImage, cancelling_writes_nothing) {
    RenderControl control;
    control.cancel();
    const Status written = write_image(in_folder("a.png"), noisy_picture(), &control);
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::cancelled);
    EXPECT_TRUE(listing().empty());
}

TEST_F(WriteImage, the_librarys_version_is_known) {
    const Result<std::string> version = image_library_version();
    ASSERT_TRUE(version.ok()) << version.error().text();
    EXPECT_EQ(version->rfind("OpenImageIO 2.", 0) == 0 || version->rfind("OpenImageIO 3.", 0) == 0, true) << *version;
}

} // namespace
} // namespace glint
