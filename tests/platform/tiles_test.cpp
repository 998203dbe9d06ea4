// Pictures larger than a texture: cut into tiles whose seams nobody sees.
#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include <glint/gles/presenter.hpp>

#include "gles/tiles.hpp"
#include "platform/picture.hpp"
#include "platform/substitutes.hpp"
#include "platform/surface_kinds.hpp"

namespace glint::test {
namespace {

TEST(tiles, one_is_enough_where_textures_are_large_enough) {
    EXPECT_EQ(gles::cut_into_tiles(64, 48, 64), (std::vector<gles::Tile>{{0, 0, 64, 48, 0, 0, 64, 48}}));
}

TEST(tiles, every_pixel_is_shown_once_and_has_its_neighbours_in_the_texture) {
    for (const uint32_t largest : {5u, 6u, 16u, 100u}) {
        for (const auto &[width, height] : {std::pair{1u, 1u}, {5u, 6u}, {17u, 16u}, {101u, 7u}, {64u, 99u}}) {
            std::vector<int> shown(size_t{width} * height);
            const std::vector<gles::Tile> tiles = gles::cut_into_tiles(width, height, largest);
            for (const gles::Tile &tile : tiles) {
                EXPECT_LE(tile.texture_width_px, largest);
                EXPECT_LE(tile.texture_height_px, largest);
                const uint32_t reach = gles::filter_reach_px;
                EXPECT_EQ(tile.texture_x, tile.x - std::min(tile.x, width <= largest ? 0 : reach));
                EXPECT_GE(tile.texture_x + tile.texture_width_px, std::min(width, tile.x + tile.width_px + reach));
                EXPECT_GE(tile.texture_y + tile.texture_height_px, std::min(height, tile.y + tile.height_px + reach));
                for (uint32_t y = tile.y; y < tile.y + tile.height_px; ++y) {
                    for (uint32_t x = tile.x; x < tile.x + tile.width_px; ++x) ++shown.at(size_t{y} * width + x);
                }
            }
            EXPECT_TRUE(std::all_of(shown.begin(), shown.end(), [](int times) { return times == 1; }))
                << width << " x " << height << " in tiles of " << largest;
        }
    }
}

TEST(tiles, there_are_none_where_borders_leave_no_room) {
    EXPECT_TRUE(gles::cut_into_tiles(64, 48, 4).empty());
    EXPECT_FALSE(gles::cut_into_tiles(4, 4, 4).empty());
}

TEST(tiles, the_largest_pictures_are_cut_without_overflow) {
    const std::vector<gles::Tile> tiles = gles::cut_into_tiles(UINT32_MAX, 1, 1u << 20);
    ASSERT_FALSE(tiles.empty());
    EXPECT_EQ(uint64_t{tiles.back().x} + tiles.back().width_px, uint64_t{UINT32_MAX});
}

PFNGLGETINTEGERVPROC real_get_integerv = nullptr;
GLint texture_limit = 0;
void get_limited_integerv(GLenum name, GLint *value) {
    real_get_integerv(name, value);
    if (name == GL_MAX_TEXTURE_SIZE) *value = texture_limit;
}

PFNGLTEXIMAGE2DPROC real_tex_image_2d = nullptr;
int textures_made = 0;
void limited_tex_image_2d(GLenum target, GLint level, GLint internal_format, GLsizei width, GLsizei height,
                          GLint border, GLenum format, GLenum type, const void *pixels) {
    ++textures_made;
    // What a driver with that limit does with more: it refuses.
    const bool fits = width <= texture_limit && height <= texture_limit;
    real_tex_image_2d(target, level, internal_format, fits ? width : -1, height, border, format, type, pixels);
}

class TiledPictures : public OnEverySurface {
protected:
    /// A presenter in a context that says it has textures of at most `limit_px` a side, and no larger ones.
    [[nodiscard]] std::unique_ptr<gles::Presenter> create(int limit_px) const {
        const gles::ProcLoader load = surface_->proc_loader();
        real_get_integerv = reinterpret_cast<PFNGLGETINTEGERVPROC>(load("glGetIntegerv"));
        real_tex_image_2d = reinterpret_cast<PFNGLTEXIMAGE2DPROC>(load("glTexImage2D"));
        texture_limit = limit_px;
        textures_made = 0;
        auto presenter = gles::Presenter::create(with_substitutes(
            load, {{"glGetIntegerv", as_proc(get_limited_integerv)}, {"glTexImage2D", as_proc(limited_tex_image_2d)}}));
        if (!presenter) throw std::runtime_error(presenter.error().text());
        return std::move(presenter).value();
    }

    [[nodiscard]] std::vector<uint8_t> scaled(gles::Presenter &presenter, const Framebuffer &picture, int x, int y,
                                              int width_px, int height_px, gles::Filter filter) {
        Result<std::unique_ptr<gles::Presenter>> background = gles::Presenter::create(surface_->proc_loader());
        EXPECT_TRUE(background);
        EXPECT_TRUE(shows(*surface_, **background, random_picture(surface_->width_px(), surface_->height_px(), 99)));
        const Status uploaded = presenter.upload(picture);
        EXPECT_TRUE(uploaded) << (uploaded ? "" : uploaded.error().text());
        EXPECT_TRUE(presenter.draw(x, y, width_px, height_px, {.filter = filter}));
        return surface_->read_back().value();
    }
};

GLINT_ON_EVERY_SURFACE(TiledPictures);

TEST_P(TiledPictures, show_every_byte) {
    const std::unique_ptr<gles::Presenter> presenter = create(64);
    uint32_t seed = 1;
    for (const auto &[width_px, height_px] :
         {std::pair{64u, 64u}, {65u, 64u}, {64u, 65u}, {60u, 130u}, {301u, 200u}, {1u, 500u}, {63u, 64u}}) {
        ASSERT_TRUE(surface_->resize(width_px, height_px));
        EXPECT_TRUE(shows(*surface_, *presenter, random_picture(width_px, height_px, seed++)))
            << width_px << " x " << height_px;
    }
    EXPECT_GT(textures_made, 20);
}

TEST_P(TiledPictures, of_a_limit_that_graphics_processors_had_show_every_byte) {
    const std::unique_ptr<gles::Presenter> presenter = create(2048);
    const Status resized = surface_->resize(2500, 2100);
    ASSERT_TRUE(resized) << resized.error().text();
    EXPECT_TRUE(shows(*surface_, *presenter, random_picture(2500, 2100, 1)));
    EXPECT_EQ(textures_made, 4);
}

/// How many bytes are further apart than that.
size_t count_differing(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b, int tolerance) {
    size_t count = 0;
    for (size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) > tolerance;
    return count;
}

TEST_P(TiledPictures, have_no_seams_when_scaled) {
    ASSERT_TRUE(surface_->resize(300, 250));
    const Framebuffer picture = random_picture(110, 90, 3);
    Result<std::unique_ptr<gles::Presenter>> whole = gles::Presenter::create(surface_->proc_loader());
    ASSERT_TRUE(whole);
    for (const int limit_px : {16, 33, 64}) {
        const std::unique_ptr<gles::Presenter> tiled = create(limit_px);
        for (const gles::Filter filter : {gles::Filter::bilinear, gles::Filter::sharp}) {
            // Larger, larger by a whole number, partly outside, smaller.
            for (const auto &[x, y, width_px, height_px] :
                 {std::tuple{0, 0, 300, 250}, {5, 7, 220, 180}, {-31, -17, 351, 333}, {3, 2, 71, 67}}) {
                const std::vector<uint8_t> expected = scaled(**whole, picture, x, y, width_px, height_px, filter);
                const std::vector<uint8_t> shown = scaled(*tiled, picture, x, y, width_px, height_px, filter);
                ASSERT_EQ(shown.size(), expected.size());
                // Neighbours differ by up to 255, so a seam would show as much; weights have 8 bits in some drivers.
                EXPECT_EQ(count_differing(shown, expected, 6), 0u)
                    << "tiles of " << limit_px << " to " << width_px << " x " << height_px;
            }
        }
    }
}

TEST_P(TiledPictures, are_blended_once_everywhere) {
    const std::unique_ptr<gles::Presenter> presenter = create(16);
    Result<std::unique_ptr<gles::Presenter>> background = gles::Presenter::create(surface_->proc_loader());
    ASSERT_TRUE(background);
    Framebuffer black = random_picture(64, 48, 1);
    std::fill_n(black.rgba8(), 64 * 48 * 4, uint8_t{0});
    Framebuffer grey = random_picture(50, 40, 1);
    std::fill_n(grey.rgba8(), 50 * 40 * 4, uint8_t{100});
    ASSERT_TRUE(shows(*surface_, **background, black));
    ASSERT_TRUE(presenter->upload(grey));
    ASSERT_TRUE(presenter->draw(0, 0, 64, 48, {.blend = gles::Blend::premultiplied}));
    const Result<std::vector<uint8_t>> shown = surface_->read_back();
    ASSERT_TRUE(shown);
    EXPECT_TRUE(std::all_of(shown->begin(), shown->end(), [](uint8_t byte) { return byte == 100; }));
}

TEST_P(TiledPictures, are_refused_where_textures_have_no_room_for_borders) {
    const std::unique_ptr<gles::Presenter> presenter = create(4);
    const Status status = presenter->upload(random_picture(64, 48, 1));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::unsupported);
    EXPECT_NE(status.error().text().find("at most 4 x 4"), std::string::npos) << status.error().text();
}

} // namespace
} // namespace glint::test
