// Textures hold what image files hold, and broken files are told of.
#include <glint/imageio.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <OpenImageIO/imageio.h>

#include "imageio/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace glint {
namespace {

class ReadTexture : public test::TemporaryFolder {
protected:
    /// Writes 2 x 2 pixels, the top row first, whose channels count up from 0 in steps of `step`.
    template <typename Sample>
    [[nodiscard]] fs::path write(const std::string &name, int channels, OIIO::TypeDesc type, Sample step) const {
        std::vector<Sample> samples;
        for (int i = 0; i < 4 * channels; ++i) samples.push_back(static_cast<Sample>(step * static_cast<Sample>(i)));
        return write_samples(name, 2, 2, channels, type, samples);
    }
    template <typename Sample> [[nodiscard]] fs::path write_samples(const std::string &name, int width, int height,
                                                                    int channels, OIIO::TypeDesc type,
                                                                    const std::vector<Sample> &samples) const {
        const fs::path file = in_folder(name);
        const auto output = OIIO::ImageOutput::create(file.string());
        OIIO::ImageSpec spec(width, height, channels, type);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        EXPECT_TRUE(output && output->open(file.string(), spec)) << OIIO::geterror();
        EXPECT_TRUE(output->write_image(type, samples.data())) << output->geterror();
        EXPECT_TRUE(output->close());
        return file;
    }
    [[nodiscard]] fs::path write_text(const std::string &name, const std::string &text) const {
        std::ofstream(in_folder(name), std::ios::binary) << text;
        return in_folder(name);
    }
    static Texture good(const fs::path &file) {
        auto texture = read_texture(file);
        if (!texture.ok()) throw std::runtime_error(texture.error().text());
        return std::move(texture).value();
    }
    static void expect_error(const fs::path &file, ErrorCode code, const std::string &why) {
        const auto texture = read_texture(file);
        ASSERT_FALSE(texture.ok()) << file;
        EXPECT_EQ(texture.error().code, code);
        ASSERT_EQ(texture.error().diagnostics.size(), 1u);
        const std::string &message = texture.error().diagnostics[0].message;
        EXPECT_EQ(message.find("cannot read the image '" + file.string() + "': "), 0u) << message;
        EXPECT_NE(message.find(why), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
};

TEST_F(ReadTexture, takes_red_green_and_blue_as_they_are) {
    for (const char *name : {"a.png", "a.tif", "a.tga", "a.bmp", "a.ppm"}) {
        const Texture texture = good(write<uint8_t>(name, 3, OIIO::TypeDesc::UINT8, 20));
        EXPECT_EQ(texture.width_px, 2u);
        EXPECT_EQ(texture.height_px, 2u);
        ASSERT_EQ(texture.texels.size(), 4u);
        for (size_t i = 0; i < 4; ++i) {
            const float first = static_cast<float>(60 * i);
            EXPECT_EQ(texture.texels[i], Color(first / 255.0f, (first + 20) / 255.0f, (first + 40) / 255.0f)) << name;
        }
    }
}

TEST_F(ReadTexture, makes_grey_of_a_single_channel) {
    const Texture texture = good(write<uint8_t>("a.png", 1, OIIO::TypeDesc::UINT8, 51));
    EXPECT_EQ(texture.texels, (std::vector<Color>{Color(0.0f), Color(0.2f), Color(0.4f), Color(0.6f)}));
}

TEST_F(ReadTexture, leaves_alpha_aside) {
    const Texture grey = good(write<uint8_t>("grey.png", 2, OIIO::TypeDesc::UINT8, 17));
    EXPECT_EQ(grey.texels[1], Color(34.0f / 255.0f));
    const Texture colour =
        good(write<uint8_t>("colour.png", 4, OIIO::TypeDesc::UINT8, 10)); // alpha is not 255 anywhere
    EXPECT_EQ(colour.texels[1], Color(40.0f / 255.0f, 50.0f / 255.0f, 60.0f / 255.0f));
    const Texture many = good(write<float>("many.exr", 6, OIIO::TypeDesc::FLOAT, 0.03125f));
    EXPECT_EQ(many.texels[1], Color(0.1875f, 0.21875f, 0.25f));
}

TEST_F(ReadTexture, takes_whole_numbers_of_any_size_as_fractions) {
    const Texture texture = good(write<uint16_t>("a.png", 3, OIIO::TypeDesc::UINT16, 5957)); // 11 of them are 65527
    EXPECT_FLOAT_EQ(texture.texels[3].z, 65527.0f / 65535.0f);
    EXPECT_EQ(texture.texels[0].x, 0.0f);
}

TEST_F(ReadTexture, cuts_floats_off_at_0_and_1) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> samples = {0.25f, 1.0f, 0.0f, -1.0f, 2.0f, inf, -inf, nan, 1e-20f};
    const Texture texture = good(write_samples("a.exr", 3, 1, 3, OIIO::TypeDesc::FLOAT, samples));
    EXPECT_EQ(texture.texels, (std::vector<Color>{{0.25f, 1, 0}, {0, 1, 1}, {0, 0, 1e-20f}}));
}

TEST_F(ReadTexture, goes_by_the_contents_whatever_the_name) {
    const fs::path file = write<uint8_t>("a.png", 3, OIIO::TypeDesc::UINT8, 20);
    fs::rename(file, in_folder("b.jpg"));
    EXPECT_EQ(good(in_folder("b.jpg")).texels.size(), 4u);
}

TEST_F(ReadTexture, refuses_what_is_no_file) {
    expect_error(in_folder("missing.png"), ErrorCode::not_found, "there is no such file");
    expect_error(in_folder(""), ErrorCode::not_found, "it is a folder, expected a file");
    expect_error("/dev/zero", ErrorCode::not_found, "it is no regular file");
    ASSERT_EQ(::mkfifo(in_folder("pipe.png").c_str(), 0600), 0);
    expect_error(in_folder("pipe.png"), ErrorCode::not_found, "it is no regular file");
}

TEST_F(ReadTexture, refuses_what_is_no_picture) {
    expect_error(write_text("a.png", ""), ErrorCode::bad_input, "");
    expect_error(write_text("a.tif", "not at all"), ErrorCode::bad_input, "");
    expect_error(write_text("a.xyz", "v 0 0 0\n"), ErrorCode::bad_input, "");
    expect_error(write_text("a", "v 0 0 0\n"), ErrorCode::bad_input, "");
    // Names that OpenImageIO takes for pictures without looking.
    expect_error(write_text("a.null", "x"), ErrorCode::bad_input, "it is no picture");
}

TEST_F(ReadTexture, refuses_files_that_are_cut_off) {
    std::vector<uint8_t> noise(3 * 64 * 64);
    uint32_t state = 1;
    for (uint8_t &byte : noise) state = state * 1664525u + 1013904223u, byte = static_cast<uint8_t>(state >> 24);
    for (const char *name : {"a.png", "a.tif", "a.tga", "a.bmp"}) {
        const fs::path file = write_samples(name, 64, 64, 3, OIIO::TypeDesc::UINT8, noise);
        fs::resize_file(file, fs::file_size(file) / 2);
        expect_error(file, ErrorCode::bad_input, "");
    }
}

TEST_F(ReadTexture, refuses_pictures_that_are_too_large) {
    // Only their headers are there.
    expect_error(write_text("wide.pgm", "P5\n8193 8192\n255\n"), ErrorCode::limit_exceeded,
                 "it has 8193 x 8192 pixels, and a texture at most 67108864");
    expect_error(write_text("huge.pgm", "P5\n70000 70000\n255\n"), ErrorCode::limit_exceeded,
                 "it has 70000 x 70000 pixels");
    expect_error(write_text("long.pgm", "P5\n1048577 1\n255\n"), ErrorCode::limit_exceeded,
                 "and a texture at most 1048576 a side");
}

} // namespace
} // namespace glint
