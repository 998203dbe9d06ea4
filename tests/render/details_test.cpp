// Smooth normals and textures. A ball of triangles with the ball's own normals is shaded as the ball itself is.
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"
#include "support/picture.hpp"

namespace glint::test {
namespace {

Material shiny() {
    Material material;
    material.color = {0.8f, 0.5f, 0.3f};
    material.ambient = 0.2f;
    material.diffuse = 0.6f;
    material.specular = 0.2f;
    material.specular_exponent = 20.0f;
    return material;
}

/// A ball of radius 1 around the origin, seen from the front.
std::shared_ptr<const Accel> with_ball(Object ball) {
    Light sun;
    sun.kind = Light::Kind::directional;
    sun.direction = {-1, -2, -3};
    ball.material = shiny();
    SceneBuilder builder;
    builder.add_object(std::move(ball)).add_light(sun).set_ambient(0.5f);
    builder.set_camera(Camera::look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.35f, 0.35f));
    const auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return Accel::build(*scene);
}

Object ball_of_triangles(bool is_smooth) {
    auto mesh = std::make_shared<Mesh>(icosphere(3));
    for (Point &p : mesh->positions) p /= std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    if (is_smooth) {
        for (const Point &p : mesh->positions) mesh->normals.push_back(p * 3.0f); // of any length
        mesh->normal_corners = mesh->triangles;
    }
    return {"ball", mesh, {}};
}

Object exact_ball() {
    Object ball{"ball", nullptr, {}};
    ball.quadric = Quadric{1, 1, 1, 0, 0, 0, 0, 0, 0, -1};
    return ball;
}

float largest_difference(const Framebuffer &a, const Framebuffer &b) {
    float largest = 0.0f;
    for (size_t i = 0; i < size_t{a.width_px()} * a.height_px() * 3; ++i) {
        largest = std::max(largest, std::abs(a.radiance()[i] - b.radiance()[i]));
    }
    return largest;
}

TEST(SmoothNormals, shade_a_ball_of_triangles_as_a_ball) {
    const auto smooth = with_ball(ball_of_triangles(true)), flat = with_ball(ball_of_triangles(false));
    const Framebuffer exact = render(with_ball(exact_ball()), 64, 64, 0, {.threads = 1, .isa = Isa::scalar});
    for (const Isa isa : available_isas()) {
        EXPECT_LT(largest_difference(render(smooth, 64, 64, 0, {.threads = 1, .isa = isa}), exact), 0.01f);
        EXPECT_GT(largest_difference(render(flat, 64, 64, 0, {.threads = 1, .isa = isa}), exact), 0.02f);
        EXPECT_EQ(render(smooth, 64, 64, 0, {.threads = 1, .isa = isa}).radiance_hash(),
                  render(smooth, 64, 64, 0, {.threads = 3, .isa = Isa::scalar}).radiance_hash());
    }
}

/// A square whose texture coordinates go from 0 to `repeats`, of 2 x 2 texels: red, green over blue, white.
std::shared_ptr<const Accel> checkered(float repeats) {
    auto texture = std::make_shared<Texture>();
    texture->width_px = texture->height_px = 2;
    texture->texels = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh->triangles = mesh->texcoord_corners = {{0, 1, 2}, {0, 2, 3}};
    mesh->texcoords = {{0, 0}, {repeats, 0}, {repeats, repeats}, {0, repeats}};
    Object square{"square", mesh, {}};
    square.material.texture = texture;
    square.material.ambient = 1.0f;
    SceneBuilder builder;
    builder.add_object(square).set_ambient(1.0f).set_camera(Camera::through_window({0, 0, 5}, -1, -1, 1, 1));
    const auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    return Accel::build(*scene);
}

TEST(Textures, are_interpolated_between_their_texels_and_repeat) {
    for (const Isa isa : available_isas()) {
        const Framebuffer once = render(checkered(1.0f), 4, 4, 0, {.threads = 1, .isa = isa});
        // Pixels' centres lie at 1/8, 3/8, ...: a quarter of a texel beyond the middles of texels, at 1/4 and 3/4.
        const auto expect = [&](uint32_t x, uint32_t y, const Color &expected) {
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(pixel(once, x, y)[channel], expected[channel], 1e-5f) << isa_name(isa) << x << y;
            }
        };
        const auto mixed = [](float right, float lower) {
            const auto mix = [](const Color &a, const Color &b, float t) { return a + (b - a) * t; };
            return mix(mix({1, 0, 0}, {0, 1, 0}, right), mix({0, 0, 1}, {1, 1, 1}, right), lower);
        };
        expect(0, 0, mixed(0.25f, 0.25f)); // beyond the left edge lies the right texel again
        expect(1, 1, mixed(0.25f, 0.25f));
        expect(2, 1, mixed(0.75f, 0.25f));
        expect(1, 2, mixed(0.25f, 0.75f));
        expect(3, 3, mixed(0.75f, 0.75f));
        const Framebuffer twice = render(checkered(2.0f), 8, 8, 0, {.threads = 1, .isa = isa});
        for (uint32_t y = 0; y < 8; ++y) {
            for (uint32_t x = 0; x < 8; ++x) {
                for (int channel = 0; channel < 3; ++channel) {
                    EXPECT_NEAR(pixel(twice, x, y)[channel], pixel(once, x % 4, y % 4)[channel], 1e-5f);
                }
            }
        }
    }
}

} // namespace
} // namespace glint::test
