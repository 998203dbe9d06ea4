// What the presenter shows is what was uploaded: every byte, on every kind of surface.
#include <array>

#include <gtest/gtest.h>

#include <glint/gles/presenter.hpp>

#include "gles/offscreen_target.hpp"
#include "platform/picture.hpp"
#include "platform/substitutes.hpp"
#include "platform/surface_kinds.hpp"

namespace glint::test {
namespace {

class PresenterTest : public OnEverySurface {
protected:
    void SetUp() override {
        OnEverySurface::SetUp();
        if (surface_ == nullptr) return;
        Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(surface_->proc_loader());
        ASSERT_TRUE(presenter) << presenter.error().text();
        presenter_ = std::move(presenter).value();
    }
    void TearDown() override { presenter_.reset(); }

    std::unique_ptr<gles::Presenter> presenter_;
};

GLINT_ON_EVERY_SURFACE(PresenterTest);

struct Size {
    uint32_t width_px, height_px;
};

// Smallest, thin, odd, tile-sized and just past it, wider than the presenter's staging buffer; up and down again.
constexpr std::array<Size, 12> sizes = {{{1, 1},
                                         {3, 5},
                                         {128, 128},
                                         {511, 257},
                                         {64, 65},
                                         {1, 300},
                                         {300, 1},
                                         {4099, 3},
                                         {512, 512},
                                         {2, 2},
                                         {127, 129},
                                         {3, 5}}};

TEST_P(PresenterTest, shows_every_byte_at_every_size) {
    uint32_t seed = 1;
    for (const Size size : sizes) {
        const Status resized = surface_->resize(size.width_px, size.height_px);
        ASSERT_TRUE(resized) << resized.error().text();
        EXPECT_TRUE(shows(*surface_, *presenter_, random_picture(size.width_px, size.height_px, seed++)));
    }
}

TEST_P(PresenterTest, shows_every_byte_through_es2_alone) {
    if (GetParam().name == std::string("osmesa")) GTEST_SKIP() << "a core profile is never without vertex arrays";
    Result<std::unique_ptr<gles::Presenter>> es2 = gles::Presenter::create(as_es2(surface_->proc_loader()));
    ASSERT_TRUE(es2) << es2.error().text();
    for (const Size size : sizes) {
        ASSERT_TRUE(surface_->resize(size.width_px, size.height_px));
        EXPECT_TRUE(shows(*surface_, **es2, random_picture(size.width_px, size.height_px, 7)));
    }
}

TEST_P(PresenterTest, shows_the_newest_of_many_pictures) {
    for (uint32_t seed = 1; seed <= 10; ++seed) {
        EXPECT_TRUE(shows(*surface_, *presenter_, random_picture(64, 48, seed)));
    }
}

TEST_P(PresenterTest, draws_one_upload_many_times) {
    const Framebuffer picture = random_picture(64, 48, 3);
    ASSERT_TRUE(presenter_->upload(picture));
    ASSERT_TRUE(presenter_->draw(0, 0, 20, 30));
    ASSERT_TRUE(presenter_->draw(0, 0, 64, 48));
    Result<std::vector<uint8_t>> shown = surface_->read_back();
    ASSERT_TRUE(shown);
    EXPECT_TRUE(same_bytes(picture, *shown));
}

TEST_P(PresenterTest, fills_the_rectangle_and_nothing_else) {
    const Framebuffer background = random_picture(64, 48, 4);
    const Framebuffer picture = random_picture(20, 10, 5);
    ASSERT_TRUE(shows(*surface_, *presenter_, background));
    ASSERT_TRUE(presenter_->upload(picture));
    // 7 pixels from the left and 9 from the bottom: rows 29 to 38 from the top.
    ASSERT_TRUE(presenter_->draw(7, 9, 20, 10));
    Result<std::vector<uint8_t>> shown = surface_->read_back();
    ASSERT_TRUE(shown);
    Framebuffer expected = random_picture(64, 48, 4);
    for (size_t row = 0; row < 10; ++row) {
        std::copy_n(picture.rgba8() + row * 80, 80, expected.rgba8() + ((29 + row) * 64 + 7) * 4);
    }
    EXPECT_TRUE(same_bytes(expected, *shown));
}

TEST_P(PresenterTest, scales_a_picture_to_its_rectangle) {
    const Framebuffer picture = random_picture(2, 2, 6);
    ASSERT_TRUE(presenter_->upload(picture));
    ASSERT_TRUE(presenter_->draw(0, 0, 64, 48));
    Result<std::vector<uint8_t>> shown = surface_->read_back();
    ASSERT_TRUE(shown);
    // Beyond the outermost texels' centres there is nothing to interpolate: the corners are the texels.
    const std::array<size_t, 4> corners = {0, 63, size_t{47} * 64, size_t{47} * 64 + 63};
    for (size_t texel = 0; texel < 4; ++texel) {
        for (size_t channel = 0; channel < 4; ++channel) {
            EXPECT_EQ((*shown)[corners[texel] * 4 + channel], picture.rgba8()[texel * 4 + channel])
                << "texel " << texel << ", channel " << channel;
        }
    }
    // In between: half way from left to right lies half way between the colours.
    const int left = picture.rgba8()[0];
    const int right = picture.rgba8()[4];
    EXPECT_NEAR((*shown)[32 * 4], (left + right) / 2, 2 + std::abs(left - right) / 32);
    EXPECT_TRUE(shows(*surface_, *presenter_, random_picture(64, 48, 8))) << "exact again after scaling";
}

TEST_P(PresenterTest, draws_nothing_into_an_empty_rectangle) {
    const Framebuffer picture = random_picture(64, 48, 9);
    ASSERT_TRUE(shows(*surface_, *presenter_, picture));
    ASSERT_TRUE(presenter_->draw(0, 0, 0, 48));
    ASSERT_TRUE(presenter_->draw(0, 0, 64, 0));
    Result<std::vector<uint8_t>> shown = surface_->read_back();
    ASSERT_TRUE(shown);
    EXPECT_TRUE(same_bytes(picture, *shown));
}

// The bytes are for the screen as they are: no second encoding where the framebuffer would do one.
TEST_P(PresenterTest, shows_every_byte_on_an_srgb_framebuffer) {
    Result<gles::Gl> gl = gles::Gl::load(surface_->proc_loader());
    ASSERT_TRUE(gl);
    if (!gl->has_srgb_switch) GTEST_SKIP() << "this context encodes always";
    GLuint texture = 0;
    GLuint framebuffer = 0;
    gl->gen_textures(1, &texture);
    gl->bind_texture(GL_TEXTURE_2D, texture);
    gl->tex_image_2d(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, 64, 48, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl->gen_framebuffers(1, &framebuffer);
    gl->bind_framebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->framebuffer_texture_2d(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    ASSERT_EQ(gl->check_framebuffer_status(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    gl->enable(GL_FRAMEBUFFER_SRGB_EXT);

    const Framebuffer picture = random_picture(64, 48, 13);
    ASSERT_TRUE(presenter_->upload(picture));
    ASSERT_TRUE(presenter_->draw(0, 0, 64, 48));
    Result<std::vector<uint8_t>> shown = gles::read_rgba8(*gl, 64, 48);
    ASSERT_TRUE(shown);
    EXPECT_TRUE(same_bytes(picture, *shown));
}

TEST_P(PresenterTest, two_presenters_share_a_context) {
    Result<std::unique_ptr<gles::Presenter>> other = gles::Presenter::create(surface_->proc_loader());
    ASSERT_TRUE(other);
    ASSERT_TRUE((*other)->upload(random_picture(5, 7, 10)));
    EXPECT_TRUE(shows(*surface_, *presenter_, random_picture(64, 48, 11)));
    EXPECT_TRUE(shows(*surface_, **other, random_picture(64, 48, 12)));
}

} // namespace
} // namespace glint::test
