// Filters and blending, and pixels that come from elsewhere than a framebuffer.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <glint/gles/presenter.hpp>

#include "platform/picture.hpp"
#include "platform/substitutes.hpp"
#include "platform/surface_kinds.hpp"

namespace glint::test {
namespace {

constexpr std::array filters = {gles::Filter::nearest, gles::Filter::bilinear, gles::Filter::sharp};

class PresenterOptions : public OnEverySurface {
protected:
    void SetUp() override {
        OnEverySurface::SetUp();
        if (surface_ == nullptr) return;
        Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(surface_->proc_loader());
        ASSERT_TRUE(presenter) << presenter.error().text();
        presenter_ = std::move(presenter).value();
    }
    void TearDown() override { presenter_.reset(); }

    /// What the surface shows after the picture was drawn over all of it.
    [[nodiscard]] std::vector<uint8_t> drawn(const gles::PixelView &picture, const gles::DrawOptions &how) {
        const auto width_px = static_cast<int>(surface_->width_px()),
                   height_px = static_cast<int>(surface_->height_px());
        if (!presenter_->upload(picture) || !presenter_->draw(0, 0, width_px, height_px, how)) return {};
        return std::move(surface_->read_back()).value();
    }

    std::unique_ptr<gles::Presenter> presenter_;
};

GLINT_ON_EVERY_SURFACE(PresenterOptions);

/// Opaque, or with the given alpha, all pixels alike.
Framebuffer plain_picture(uint32_t width_px, uint32_t height_px, std::array<uint8_t, 4> color) {
    Framebuffer picture = Framebuffer::create(width_px, height_px, false).value();
    for (size_t i = 0; i < size_t{width_px} * height_px; ++i) std::copy_n(color.data(), 4, picture.rgba8() + 4 * i);
    return picture;
}

TEST_P(PresenterOptions, every_filter_shows_every_byte_in_the_pictures_own_size) {
    for (const gles::Filter filter : filters) {
        const Framebuffer picture = random_picture(64, 48, 1);
        EXPECT_TRUE(same_bytes(picture, drawn(picture, {.filter = filter}))) << static_cast<int>(filter);
    }
}

TEST_P(PresenterOptions, nearest_makes_squares) {
    const Framebuffer picture = random_picture(16, 12, 2);
    Framebuffer expected = random_picture(64, 48, 1);
    for (size_t y = 0; y < 48; ++y) {
        for (size_t x = 0; x < 64; ++x) {
            std::copy_n(picture.rgba8() + (y / 4 * 16 + x / 4) * 4, 4, expected.rgba8() + (y * 64 + x) * 4);
        }
    }
    EXPECT_TRUE(same_bytes(expected, drawn(picture, {.filter = gles::Filter::nearest})));
}

/// The pictures' bytes farthest from each other.
int largest_difference(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b) {
    int largest = a.size() == b.size() ? 0 : 256;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// An edge through the picture's middle, white on the side that `normal` points to.
Framebuffer edge_picture(uint32_t size_px, double normal_x, double normal_y) {
    Framebuffer picture = Framebuffer::create(size_px, size_px, false).value();
    const double middle = 0.5 * size_px;
    for (uint32_t i = 0; i < size_px * size_px; ++i) {
        const double x = i % size_px + 0.5 - middle, y = i / size_px + 0.5 - middle;
        std::fill_n(picture.rgba8() + 4 * i, 3, x * normal_x + y * normal_y > 0 ? uint8_t{255} : uint8_t{0});
        picture.rgba8()[4 * i + 3] = 255;
    }
    return picture;
}

double mean_square_error(const std::vector<uint8_t> &shown, const Framebuffer &wanted) {
    double sum = 0.0;
    for (size_t i = 0; i < shown.size(); ++i) sum += std::pow(int{shown[i]} - int{wanted.rgba8()[i]}, 2);
    return sum / static_cast<double>(shown.size());
}

TEST_P(PresenterOptions, sharp_draws_slanted_edges_nearer_to_the_truth_than_bilinear) {
    ASSERT_TRUE(surface_->resize(96, 96));
    double sharp_sum = 0.0, bilinear_sum = 0.0;
    for (const auto &[x, y] : {std::pair{1.0, 0.9}, {1.0, 0.5}, {-0.4, 1.0}, {0.3, -1.0}}) {
        const Framebuffer wanted = edge_picture(96, x, y);
        const Framebuffer traced = edge_picture(32, x, y);
        const double sharp = mean_square_error(drawn(traced, {.filter = gles::Filter::sharp}), wanted);
        const double bilinear = mean_square_error(drawn(traced, {.filter = gles::Filter::bilinear}), wanted);
        EXPECT_LT(sharp, bilinear) << x << ", " << y;
        sharp_sum += sharp;
        bilinear_sum += bilinear;
    }
    EXPECT_LT(sharp_sum, 0.92 * bilinear_sum);
    EXPECT_GT(sharp_sum, 0.5 * bilinear_sum) << "it cannot know the truth";
}

TEST_P(PresenterOptions, sharp_neither_overshoots_nor_shifts) {
    const Framebuffer plain = plain_picture(13, 11, {40, 200, 90, 255});
    EXPECT_LE(largest_difference(drawn(plain, {.filter = gles::Filter::sharp}),
                                 drawn(plain, {.filter = gles::Filter::nearest})),
              1);
    // Left dark, right bright: no pixel is darker or brighter, and the middle of the edge stays in the middle.
    const std::vector<uint8_t> shown = drawn(edge_picture(8, 1.0, 0.0), {.filter = gles::Filter::sharp});
    for (size_t x = 1; x < 64; ++x) EXPECT_GE(shown[4 * (64 * 20 + x)], shown[4 * (64 * 20 + x) - 4]);
    EXPECT_NEAR(shown[4 * (64 * 20 + 31)] + shown[4 * (64 * 20 + 32)], 255, 2);
}

TEST_P(PresenterOptions, where_a_side_shrinks_sharp_is_bilinear) {
    const Framebuffer picture = random_picture(65, 20, 3);
    EXPECT_EQ(drawn(picture, {.filter = gles::Filter::sharp}), drawn(picture, {.filter = gles::Filter::bilinear}));
    const Framebuffer smaller = random_picture(60, 20, 3);
    EXPECT_NE(drawn(smaller, {.filter = gles::Filter::sharp}), drawn(smaller, {.filter = gles::Filter::bilinear}));
}

TEST_P(PresenterOptions, without_blending_alpha_is_written) {
    ASSERT_FALSE(drawn(plain_picture(64, 48, {100, 100, 100, 255}), {}).empty());
    const Framebuffer picture = random_picture(64, 48, 4);
    EXPECT_TRUE(same_bytes(picture, drawn(picture, {.blend = gles::Blend::replace})));
}

TEST_P(PresenterOptions, alpha_lets_the_picture_below_shine_through) {
    const Framebuffer below = random_picture(64, 48, 5);
    const Framebuffer above = random_picture(64, 48, 6);
    for (const gles::Blend blend : {gles::Blend::straight, gles::Blend::premultiplied}) {
        ASSERT_FALSE(drawn(below, {}).empty());
        const std::vector<uint8_t> shown = drawn(above, {.blend = blend});
        ASSERT_EQ(shown.size(), size_t{64 * 48 * 4});
        for (size_t i = 0; i < shown.size(); ++i) {
            const double source = above.rgba8()[i], target = below.rgba8()[i];
            const double alpha = above.rgba8()[i / 4 * 4 + 3] / 255.0;
            const bool as_it_is = blend == gles::Blend::premultiplied || i % 4 == 3;
            const double expected = std::min(255.0, source * (as_it_is ? 1.0 : alpha) + target * (1.0 - alpha));
            ASSERT_NEAR(shown[i], expected, 1.01) << "byte " << i;
        }
    }
}

TEST_P(PresenterOptions, a_second_presenter_draws_over_the_first) {
    Result<std::unique_ptr<gles::Presenter>> display = gles::Presenter::create(surface_->proc_loader());
    ASSERT_TRUE(display);
    const Framebuffer below = plain_picture(64, 48, {200, 0, 0, 255});
    ASSERT_TRUE((*display)->upload(plain_picture(10, 5, {0, 0, 255, 128})));
    ASSERT_FALSE(drawn(below, {}).empty());
    ASSERT_TRUE((*display)->draw(2, 3, 20, 10, {.blend = gles::Blend::straight}));
    const std::vector<uint8_t> shown = surface_->read_back().value();
    for (size_t y = 0; y < 48; ++y) {
        for (size_t x = 0; x < 64; ++x) {
            const bool covered = x >= 2 && x < 22 && 47 - y >= 3 && 47 - y < 13;
            ASSERT_NEAR(shown[4 * (64 * y + x)], covered ? 99.6 : 200, 1.01) << x << ", " << y;
            ASSERT_NEAR(shown[4 * (64 * y + x) + 2], covered ? 128 : 0, 1.01) << x << ", " << y;
        }
    }
}

PFNGLSHADERSOURCEPROC real_shader_source = nullptr;
void shader_source_without_highp(GLuint shader, GLsizei, const GLchar *const *texts, const GLint *) {
    std::string text = texts[0];
    const std::string_view name = "GL_FRAGMENT_PRECISION_HIGH";
    for (size_t at = text.find(name); at != std::string::npos; at = text.find(name))
        text.replace(at, name.size(), "NO");
    const GLchar *changed = text.c_str();
    real_shader_source(shader, 1, &changed, nullptr);
}

TEST_P(PresenterOptions, graphics_processors_without_highp_get_along) {
    const gles::ProcLoader load = surface_->proc_loader();
    real_shader_source = reinterpret_cast<PFNGLSHADERSOURCEPROC>(load("glShaderSource"));
    auto poor =
        gles::Presenter::create(with_substitutes(load, {{"glShaderSource", as_proc(shader_source_without_highp)}}));
    ASSERT_TRUE(poor) << poor.error().text();
    const Framebuffer picture = random_picture(64, 48, 1);
    EXPECT_TRUE(shows(*surface_, **poor, picture));
    const Framebuffer small = random_picture(16, 12, 2);
    const std::vector<uint8_t> squares = drawn(small, {.filter = gles::Filter::nearest});
    ASSERT_TRUE((*poor)->upload(small));
    const Status status = (*poor)->draw(0, 0, 64, 48, {.filter = gles::Filter::sharp});
    ASSERT_TRUE(status) << status.error().text();
    EXPECT_EQ(surface_->read_back().value(), squares);
}

/// 64 x 48 pixels of a larger picture, at an address of no particular alignment.
TEST_P(PresenterOptions, rows_may_have_gaps_of_any_size) {
    for (const size_t stride_bytes : {size_t{256}, size_t{260}, size_t{1024}, size_t{257}, size_t{1023}}) {
        std::vector<uint8_t> memory(1 + 48 * stride_bytes);
        Framebuffer expected = random_picture(64, 48, static_cast<uint32_t>(stride_bytes));
        for (size_t y = 0; y < 48; ++y) std::copy_n(expected.rgba8() + 256 * y, 256, &memory[1 + y * stride_bytes]);
        const gles::PixelView view(&memory[1], 64, 48, stride_bytes);
        EXPECT_TRUE(same_bytes(expected, drawn(view, {}))) << stride_bytes;
        if (GetParam().name == std::string("osmesa")) continue; // a core profile is never without vertex arrays
        // Without GL_UNPACK_ROW_LENGTH, and without BGRA.
        auto es2 = gles::Presenter::create(as_es2(surface_->proc_loader()));
        ASSERT_TRUE(es2);
        ASSERT_TRUE((*es2)->upload(view));
        ASSERT_TRUE((*es2)->draw(0, 0, 64, 48));
        EXPECT_TRUE(same_bytes(expected, surface_->read_back().value())) << stride_bytes << " on ES 2.0";
    }
}

} // namespace
} // namespace glint::test
