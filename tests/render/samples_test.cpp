// Samples in a pixel, the tone curve and the transfer curve, on every instruction set.
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/samples.hpp"
#include "support/picture.hpp"

namespace glint::test {
namespace {

/// White right of x = 0, black left of it, seen from the front.
std::shared_ptr<const Accel> half_white(float tone_scale = 0.0f, Color white = Color(1.0f)) {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{0, -9, -4}, {9, -9, -4}, {9, 9, -4}, {0, 9, -4}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    Light glow{"glow", mesh, white};
    auto behind = std::make_shared<Mesh>();
    behind->positions = {{-90, -90, -50}, {90, -90, -50}, {0, 90, -50}};
    behind->triangles = {{0, 1, 2}};
    Material black;
    black.color = Color(0.0f);
    SceneBuilder builder;
    PictureSettings picture;
    picture.tone_scale = tone_scale;
    picture.seed = 5;
    builder.add_light(glow).add_object({"behind", behind, black}).set_picture(picture);
    builder.set_camera(Camera::through_window({0, 0, 5}, -1, -1, 1, 1));
    const auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return Accel::build(*scene);
}

Framebuffer picture_of(const std::shared_ptr<const Accel> &accel, uint32_t width, uint32_t height, Isa isa,
                       const RenderOptions &options) {
    auto target = Framebuffer::create(width, height);
    EXPECT_TRUE(Renderer(accel, {.threads = 2, .isa = isa}).render(*target, options));
    return std::move(target).value();
}

TEST(Samples, share_out_the_pixel_that_an_edge_goes_through) {
    // Three pixels in a row: the edge goes through the middle of the second one.
    RenderOptions options;
    options.samples_per_pixel = 16;
    for (const SamplePattern pattern : {SamplePattern::centre, SamplePattern::stratified, SamplePattern::jittered}) {
        options.pattern = pattern;
        const auto accel = half_white();
        const Framebuffer expected = picture_of(accel, 33, 33, Isa::scalar, options);
        EXPECT_EQ(pixel(expected, 4, 9).x, 0.0f);
        EXPECT_EQ(pixel(expected, 30, 9).x, 1.0f);
        float sum = 0.0f;
        for (uint32_t y = 0; y < 33; ++y) sum += pixel(expected, 16, y).x;
        EXPECT_NEAR(sum / 33.0f, 0.5f, pattern == SamplePattern::jittered ? 0.1f : 0.02f);
        for (const Isa isa : available_isas()) {
            const Framebuffer picture = picture_of(accel, 33, 33, isa, options);
            EXPECT_EQ(picture.radiance_hash(), expected.radiance_hash()) << isa_name(isa);
            EXPECT_EQ(picture.pixel_hash(), expected.pixel_hash()) << isa_name(isa);
        }
    }
}

TEST(Samples, lie_in_their_own_cells) {
    const SampleGrid grid = sample_grid(12, SamplePattern::stratified, 3);
    EXPECT_EQ(grid.columns * grid.rows, 12u);
    for (uint32_t sample = 0; sample < 12; ++sample) {
        const glm::vec2 place = sample_place(grid, 7, 9, sample);
        EXPECT_EQ(static_cast<uint32_t>(place.x * static_cast<float>(grid.columns)), sample % grid.columns);
        EXPECT_EQ(static_cast<uint32_t>(place.y * static_cast<float>(grid.rows)), sample / grid.columns);
    }
    EXPECT_EQ(sample_place(sample_grid(1, SamplePattern::centre, 0), 3, 4, 0), glm::vec2(0.5f));
    EXPECT_NE(sample_place(grid, 7, 9, 0), sample_place(grid, 8, 9, 0));
    EXPECT_NE(sample_place(grid, 7, 9, 0), sample_place(sample_grid(12, SamplePattern::stratified, 4), 7, 9, 0));
}

TEST(Samples, more_than_the_limit_are_refused) {
    auto target = Framebuffer::create(4, 4);
    RenderOptions options;
    options.samples_per_pixel = max_samples + 1;
    EXPECT_FALSE(Renderer(half_white()).render(*target, options).ok());
    options.samples_per_pixel = 0;
    EXPECT_FALSE(Renderer(half_white()).render(*target, options).ok());
}

TEST(Curves, change_the_bytes_and_leave_the_light_alone) {
    for (const float tone : {0.0f, 2.0f}) {
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
            const auto accel = half_white(tone, {0.5f, 0.002f, 3.0f});
            RenderOptions options;
            options.transfer = transfer;
            for (const Isa isa : available_isas()) {
                const Framebuffer picture = picture_of(accel, 32, 32, isa, options);
                const Color light = pixel(picture, 30, 9);
                EXPECT_EQ(light, Color(0.5f, 0.002f, 3.0f));
                for (int channel = 0; channel < 3; ++channel) {
                    double c = light[channel];
                    if (tone > 0.0f) c = c / (c + double(tone));
                    c = c < 1.0 ? c : 1.0;
                    if (transfer == Transfer::srgb) {
                        c = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
                    }
                    EXPECT_EQ(picture.rgba8()[(9 * 32 + 30) * 4 + channel], static_cast<int>(std::round(255.0 * c)))
                        << isa_name(isa);
                }
                EXPECT_EQ(picture.rgba8()[(9 * 32 + 2) * 4], 0) << "black stays black";
            }
        }
    }
}

} // namespace
} // namespace glint::test
