// The extension decides the format.
#include "imageio/image_format.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include <glint/imageio.hpp>

namespace glint {
namespace {

using imageio::Content;

TEST(ImageFormat, an_extension_is_known_in_upper_and_lower_case) {
    for (const char *name : {"a.png", "a.PNG", "folder.exr/a.Png", "a.b.png"}) {
        const imageio::ImageFormat *format = imageio::find_format(name);
        ASSERT_NE(format, nullptr) << name;
        EXPECT_EQ(format->oiio_name, "png");
    }
}

TEST(ImageFormat, exr_and_hdr_keep_radiance_and_the_others_do_not) {
    for (const std::string &extension : image_extensions()) {
        EXPECT_EQ(image_needs_radiance("picture." + extension), extension == "exr" || extension == "hdr") << extension;
    }
    EXPECT_FALSE(image_needs_radiance("picture.unknown"));
}

TEST(ImageFormat, no_extension_is_listed_twice) {
    const std::vector<std::string> extensions = image_extensions();
    EXPECT_EQ(std::set<std::string>(extensions.begin(), extensions.end()).size(), extensions.size());
}

TEST(ImageFormat, an_unknown_extension_is_an_error_that_lists_the_known_ones) {
    const Result<imageio::ImageFormat> format = imageio::choose_format("picture.xyz");
    ASSERT_FALSE(format.ok());
    EXPECT_EQ(format.error().code, ErrorCode::bad_input);
    const std::string text = format.error().text();
    EXPECT_NE(text.find("'xyz'"), std::string::npos) << text;
    for (const std::string &extension : image_extensions()) EXPECT_NE(text.find(extension), std::string::npos) << text;
}

TEST(ImageFormat, a_missing_extension_is_an_error_for_a_file_and_png_for_a_device) {
    const Result<imageio::ImageFormat> file = imageio::choose_format("picture");
    ASSERT_FALSE(file.ok());
    EXPECT_NE(file.error().text().find("no extension"), std::string::npos) << file.error().text();

    const Result<imageio::ImageFormat> device = imageio::choose_format("/dev/null");
    ASSERT_TRUE(device.ok());
    EXPECT_EQ(device->extension, "png");
}

} // namespace
} // namespace glint
