// Refraction against Snell's law worked out by hand. A wall behind the glass shows by its colour where it was hit: red
// is x, green is y, as a texture has it. Every instruction set is asked.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/picture.hpp"

namespace glint::test {
namespace {

constexpr float half_wall = 5.0f;

/// At depth z, 10 x 10, with a texture that tells places.
Object telling_wall(float z) {
    constexpr uint32_t side = 256;
    auto texture = std::make_shared<Texture>();
    texture->width_px = texture->height_px = side;
    for (uint32_t row = 0; row < side; ++row) {
        for (uint32_t column = 0; column < side; ++column) {
            const auto middle = [](uint32_t i) { return (static_cast<float>(i) + 0.5f) / side; };
            texture->texels.emplace_back(middle(column), 1.0f - middle(row), 0.0f);
        }
    }
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {
        {-half_wall, -half_wall, z}, {half_wall, -half_wall, z}, {half_wall, half_wall, z}, {-half_wall, half_wall, z}};
    mesh->triangles = mesh->texcoord_corners = {{0, 1, 2}, {0, 2, 3}};
    mesh->texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    Object wall{"wall", mesh, {}};
    wall.material.ambient = 1.0f;
    wall.material.diffuse = 0.0f;
    wall.material.texture = texture;
    return wall;
}

Material glass(float ior) {
    Material material;
    material.diffuse = 0.0f;
    material.transmission = 1.0f;
    material.ior = ior;
    return material;
}

/// A box, wound at random: refraction must not look at that.
std::shared_ptr<const Mesh> box(Point lo, Point hi) {
    auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i < 8; ++i) {
        mesh->positions.emplace_back((i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y,
                                     (i & 4) != 0 ? hi.z : lo.z);
    }
    mesh->triangles = {{0, 1, 3}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 4, 5},
                       {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 5, 7}};
    return mesh;
}

Quadric sphere(Point centre, float radius) {
    Quadric q;
    q.a = q.b = q.c = 1.0f;
    q.g = -centre.x;
    q.h = -centre.y;
    q.j = -centre.z;
    q.k = centre.x * centre.x + centre.y * centre.y + centre.z * centre.z - radius * radius;
    return q;
}

/// Directions of primary rays, as multiples of z = -1, and where they are expected to meet the wall.
using Expected = std::function<double(double slope)>;

constexpr uint32_t size = 96;

/// Looks along -z from the origin, through a window of the given half width at distance 1, and compares distances from
/// the axis on the wall with those expected. Returns how many pixels were compared.
int compare(SceneBuilder &builder, float half_window, const Expected &expected, uint32_t depth, double tolerance) {
    builder.set_camera(Camera::look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 2 * half_window, 2 * half_window));
    builder.set_ambient(1.0f);
    const auto scene = builder.build();
    if (!scene) throw std::runtime_error(scene.error().text());
    const auto accel = Accel::build(*scene);
    int compared = 0;
    for (const Isa isa : available_isas()) {
        const Framebuffer picture = render(accel, size, size, depth, {.threads = 1, .isa = isa});
        for (uint32_t y = 0; y < size; ++y) {
            for (uint32_t x = 0; x < size; ++x) {
                const double sx = half_window * (2.0 * (x + 0.5) / size - 1.0);
                const double sy = half_window * (1.0 - 2.0 * (y + 0.5) / size);
                const double slope = std::sqrt(sx * sx + sy * sy);
                const double distance = expected(slope);
                if (std::isnan(distance)) continue;
                const double wall_x = distance * sx / slope, wall_y = distance * sy / slope;
                if (std::abs(wall_x) > 4.9 || std::abs(wall_y) > 4.9) continue;
                const Color seen = pixel(picture, x, y);
                EXPECT_NEAR(seen.x * 10.0 - 5.0, wall_x, tolerance) << isa_name(isa) << ' ' << x << ' ' << y;
                EXPECT_NEAR(seen.y * 10.0 - 5.0, wall_y, tolerance) << isa_name(isa) << ' ' << x << ' ' << y;
                if (testing::Test::HasFailure()) return compared;
                ++compared;
            }
        }
    }
    return compared;
}

TEST(Refraction, displaces_what_is_seen_through_a_slab) {
    constexpr double ior = 1.5, thickness = 2.0;
    SceneBuilder builder;
    builder.add_object(telling_wall(-6)).add_object({"slab", box({-20, -20, -4}, {20, 20, -2}), glass(1.5f)});
    const int compared = compare(
        builder, 0.7f,
        [&](double slope) {
            const double sine = slope / std::sqrt(1.0 + slope * slope) / ior;
            return slope * (6.0 - thickness) + thickness * sine / std::sqrt(1.0 - sine * sine);
        },
        2, 1e-4);
    EXPECT_GT(compared, 5000);
}

/// Where a ray from the origin meets the wall behind a ball on the axis: it comes in and out at the same angles, and
/// passes the centre at the same distance before and after.
double behind_ball(double slope, double centre, double radius, double ior, double wall) {
    const double angle = std::atan(slope), passes = centre * std::sin(angle);
    if (passes >= 0.9 * radius) return NAN; // beyond, a ray runs along the wall rather than into it
    const double turn = 2.0 * (std::asin(passes / radius) - std::asin(passes / radius / ior));
    // After the turn towards the axis, the line's direction and its distance from the centre are known.
    const double after = angle - turn;
    return (wall - centre) * std::tan(after) + passes / std::cos(after);
}

TEST(Refraction, of_a_ball_turns_rays_as_snells_law_has_it) {
    for (const float ior : {1.33f, 1.5f, 2.4f}) {
        SceneBuilder builder;
        Object ball{"ball", nullptr, glass(ior)};
        ball.quadric = sphere({0, 0, -4}, 1.0f);
        builder.add_object(telling_wall(-6)).add_object(ball);
        const int compared = compare(
            builder, 0.25f, [&](double slope) { return behind_ball(slope, 4.0, 1.0, double(ior), 6.0); }, 2, 1e-4);
        EXPECT_GT(compared, 5000) << ior;
    }
}

TEST(Refraction, of_a_ball_brings_light_to_its_focal_point) {
    // A ball's focal length from its centre is n R / 2 (n - 1); 1 / object + 1 / image = 1 / focal.
    constexpr double ior = 1.5, radius = 0.5, object = 40.0, focal = ior * radius / (2.0 * (ior - 1.0));
    constexpr double image = object * focal / (object - focal);
    SceneBuilder builder;
    Object ball{"ball", nullptr, glass(1.5f)};
    ball.quadric = sphere({0, 0, -40}, 0.5f);
    builder.add_object(telling_wall(static_cast<float>(-object - image))).add_object(ball);
    // Near the axis, up to a twentieth of the radius.
    EXPECT_GT(compare(
                  builder, 0.0005f, [](double) { return 0.0; }, 2, 1e-4),
              5000);
}

TEST(Refraction, is_total_beyond_the_critical_angle) {
    // The eye is inside a block of glass whose flat end lies at z = -2; what is not seen through it is seen in it.
    constexpr double ior = 1.5;
    SceneBuilder builder;
    builder.add_object({"block", box({-50, -50, -2}, {50, 50, 50}), glass(1.5f)});
    Object white = telling_wall(-3);
    white.mesh = box({-60, -60, -4}, {60, 60, -3});
    white.material.texture = nullptr;
    builder.add_object(white);
    builder.set_camera(Camera::look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 4, 4)).set_ambient(1.0f);
    const auto scene = builder.build();
    ASSERT_TRUE(scene);
    const double critical = std::tan(std::asin(1.0 / ior));
    for (const Isa isa : available_isas()) {
        const Framebuffer picture = render(Accel::build(*scene), size, size, 1, {.threads = 1, .isa = isa});
        int through = 0, mirrored = 0;
        for (uint32_t y = 0; y < size; ++y) {
            for (uint32_t x = 0; x < size; ++x) {
                const double slope =
                    std::hypot(2.0 * (2.0 * (x + 0.5) / size - 1.0), 2.0 * (2.0 * (y + 0.5) / size - 1.0));
                if (std::abs(slope - critical) < 1e-4) continue;
                const bool sees_white = pixel(picture, x, y).x == 1.0f;
                EXPECT_EQ(sees_white, slope < critical) << isa_name(isa) << ' ' << slope;
                (sees_white ? through : mirrored)++;
            }
        }
        EXPECT_GT(through, 500);
        EXPECT_GT(mirrored, 500);
    }
}

TEST(Refraction, between_nested_media_counts_their_indices) {
    // Air, a block of 1.33, a block of 1.5 in it, and out again: parallel faces, so each layer only displaces.
    SceneBuilder builder;
    builder.add_object(telling_wall(-8));
    builder.add_object({"water", box({-20, -20, -7}, {20, 20, -2}), glass(1.33f)});
    builder.add_object({"flint", box({-19, -19, -5}, {19, 19, -4}), glass(1.7f)});
    const auto tangent = [](double slope, double ior) {
        const double sine = slope / std::sqrt(1.0 + slope * slope) / ior;
        return sine / std::sqrt(1.0 - sine * sine);
    };
    const int compared = compare(
        builder, 0.5f,
        [&](double slope) { return slope * 3.0 + tangent(slope, double(1.33f)) * 4.0 + tangent(slope, double(1.7f)); },
        4, 1e-4);
    EXPECT_GT(compared, 5000);
}

TEST(Refraction, by_fresnel_mirrors_four_percent_at_right_angles_and_all_at_grazing_ones) {
    for (const bool fresnel : {false, true}) {
        SceneBuilder builder;
        builder.add_object({"slab", box({-1000, -1000, -4}, {1000, 1000, -2}), glass(1.5f)});
        builder.set_optics({fresnel, false}).set_background({1, 1, 1});
        builder.set_camera(Camera::look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1e-3f, 1e-3f));
        const auto scene = builder.build();
        ASSERT_TRUE(scene);
        // At depth 1 the transmitted ray ends in the glass, which is black; what is mirrored is white.
        const Color seen = pixel(render(*scene, 1, 1, 1), 0, 0);
        EXPECT_NEAR(seen.x, fresnel ? 0.04 : 0.0, 1e-6);
    }
}

TEST(Refraction, ends_at_the_depth_that_reflection_shares) {
    SceneBuilder builder;
    Object ball{"ball", nullptr, glass(1.5f)};
    ball.quadric = sphere({0, 0, -4}, 1.0f);
    builder.add_object(ball).set_background({1, 1, 1});
    builder.set_camera(Camera::look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 0.01f, 0.01f));
    const auto scene = builder.build();
    ASSERT_TRUE(scene);
    EXPECT_EQ(pixel(render(*scene, 1, 1, 1), 0, 0).x, 0.0f) << "the ray stays in the ball";
    EXPECT_EQ(pixel(render(*scene, 1, 1, 2), 0, 0).x, 1.0f);
}

} // namespace
} // namespace glint::test
