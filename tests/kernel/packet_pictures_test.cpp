// Every kernel's pictures of odd scenes are the scalar kernel's, to the last bit of every float.
#include <cmath>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/picture.hpp"
#include "support/random.hpp"

namespace glint::test {
namespace {

const Material matt{{0.9f, 0.8f, 0.7f}, 0.2f, 0.8f, 0.0f, 0.0f, 0.0f, 0.0f};
const Material mirror{{0.9f, 0.8f, 0.7f}, 0.2f, 0.5f, 0.3f, 20.0f, 0.5f, 0.0f};
const Material glass{{0.3f, 0.8f, 0.9f}, 0.2f, 0.6f, 0.2f, 5.5f, 0.3f, 0.6f};

std::shared_ptr<Mesh> shared(Mesh mesh) {
    return std::make_shared<Mesh>(std::move(mesh));
}

Mesh scaled(Mesh mesh, float factor) {
    for (Point &p : mesh.positions) p *= factor;
    return mesh;
}

/// A scene in the making, seen from z = 4 through a window in the plane z = 0.
struct Draft {
    SceneBuilder builder;

    Draft() {
        builder.set_ambient(0.3f).set_background({0.1f, 0.1f, 0.2f});
        builder.set_camera(Camera::through_window({0, 0, 4}, -1.2f, -0.9f, 1.2f, 0.9f));
    }
    Draft &object(Mesh mesh, const Material &material) {
        builder.add_object({"object", shared(std::move(mesh)), material});
        return *this;
    }
    Draft &lamp(const Point &at, float size = 1.0f, float intensity = 0.8f) {
        builder.add_light({"lamp", shared(moved(scaled(tetrahedron(), size), at)), Color(1.0f), intensity});
        return *this;
    }
    [[nodiscard]] std::shared_ptr<const Scene> scene() {
        auto made = builder.build();
        if (!made) throw std::runtime_error(made.error().text());
        return *made;
    }
};

std::shared_ptr<const Scene> looking_away() {
    return Draft().object(moved(icosphere(2), {0, 0, 9}), mirror).lamp({4, 6, 7}).scene();
}

std::shared_ptr<const Scene> one_triangle() {
    return Draft().object({{{-1, -1, -1}, {1, -1, -2}, {0, 1, -1}}, {{0, 1, 2}}}, mirror).lamp({1, 2, 3}, 0.1f).scene();
}

/// Everything mirrors and transmits: each hit makes two rays.
std::shared_ptr<const Scene> branching() {
    return Draft()
        .object(moved(turned(torus(16, 8)), {0, 0, -1.5f}), glass)
        .object(moved(soup(30), {0, 0, -3}), glass)
        .object(moved(flat_grid(3), {0, 0, -5}), mirror)
        .lamp({4, 6, 3})
        .scene();
}

std::shared_ptr<const Scene> many_lights() {
    Draft draft;
    draft.object(moved(turned(torus(20, 10)), {0, 0, -1.5f}), mirror).object(moved(flat_grid(4), {0, 0, -3}), matt);
    Random random(4);
    for (int i = 0; i < 40; ++i) draft.lamp(random.in_box({-4, -4, -2}, {4, 4, 5}), 0.05f, 0.05f);
    return draft.scene();
}

/// The same scene in other units.
std::shared_ptr<const Scene> of_size(float unit) {
    Draft draft;
    draft.builder.set_camera(
        Camera::through_window({0, 0, 4 * unit}, -1.2f * unit, -0.9f * unit, 1.2f * unit, 0.9f * unit));
    return draft.object(scaled(moved(turned(torus(16, 8)), {0, 0, -1.5f}), unit), mirror)
        .object(scaled(moved(soup(30), {0, 0, -3}), unit), glass)
        .lamp(Point(4, 6, 3) * unit, unit)
        .scene();
}

std::shared_ptr<const Scene> inside_a_mesh() {
    return Draft()
        .object(scaled(icosphere(3), 6.0f), mirror)
        .object(moved(turned(cube()), {0, 0, -3}), glass)
        .lamp({1, 2, 3}, 0.1f)
        .scene();
}

/// Four hundred highlights side by side, each as sharp as its own exponent makes it: 0, whole, broken, up to 10^6. The
/// lanes of a vector have different ones.
std::shared_ptr<const Scene> many_exponents() {
    const Mesh plane = flat_grid(14);
    Draft draft;
    Random random(6);
    const float special[] = {0.0f, 1e-30f, 0.5f, 1.0f, 2.0f, 10.0f, 126.0f, 1000.0f, 1e6f};
    uint32_t number = 0;
    for (const Triangle &t : plane.triangles) {
        const float exponent =
            number % 4 == 0 ? special[number / 4 % std::size(special)] : std::exp(random.uniform(-5.0f, 13.8f));
        const Mesh one{{plane.positions[t.a], plane.positions[t.b], plane.positions[t.c]}, {{0, 1, 2}}};
        draft.object(one, {{0.5f, 0.5f, 0.5f}, 0.0f, 0.0f, 0.9f, exponent, 0.0f, 0.0f});
        ++number;
    }
    return draft.lamp({0.05f, 0.02f, 4.1f}, 0.01f, 0.6f).lamp({2.0f, 1.0f, 3.0f}, 0.01f, 0.4f).scene();
}

std::shared_ptr<const Scene> mixture() {
    Draft draft;
    const Material materials[] = {matt, mirror, glass};
    uint32_t number = 0;
    for (const NamedMesh &mesh : all_meshes()) {
        if (mesh.name == "small_in_large" || mesh.name == "far_torus") continue;
        const auto x = static_cast<float>(number % 4), y = static_cast<float>(number / 4);
        draft.object(moved(scaled(mesh.mesh, 0.35f), {0.8f * x - 1.2f, 0.7f * y - 1.0f, -1}), materials[number % 3]);
        ++number;
    }
    return draft.lamp({4, 6, 3}).lamp({-3, 0, 5}, 0.3f, 0.4f).scene();
}

struct OddScene {
    const char *name;
    std::function<std::shared_ptr<const Scene>()> make;
    uint32_t depth;
};
std::ostream &operator<<(std::ostream &out, const OddScene &scene) {
    return out << scene.name;
}

const OddScene odd_scenes[] = {
    {"looking_away", looking_away, 3},
    {"one_triangle", one_triangle, 2},
    {"branching", branching, 8},
    {"many_lights", many_lights, 2},
    {"huge", [] { return of_size(1e9f); }, 4},
    {"tiny", [] { return of_size(1e-6f); }, 4},
    {"inside_a_mesh", inside_a_mesh, 5},
    {"many_exponents", many_exponents, 0},
    {"mixture", mixture, 4},
};

struct Picture {
    Framebuffer pixels;
    RenderStatistics statistics;
};

Picture picture_of(const std::shared_ptr<const Accel> &accel, Isa isa, uint32_t width, uint32_t height,
                   uint32_t depth) {
    Picture picture{std::move(*Framebuffer::create(width, height)), {}};
    RenderOptions options;
    options.max_depth = depth;
    Renderer renderer(accel, {2, isa});
    const auto done = renderer.render(picture.pixels, options);
    if (!done) throw std::runtime_error(done.error().text());
    picture.statistics = *done;
    return picture;
}

std::vector<std::pair<std::shared_ptr<const Accel>, Isa>> every_way(const std::shared_ptr<const Accel> &tree,
                                                                    const std::shared_ptr<const Accel> &hierarchy) {
    std::vector<std::pair<std::shared_ptr<const Accel>, Isa>> ways;
    for (const Isa isa : available_isas()) {
        ways.emplace_back(tree, isa);
        ways.emplace_back(hierarchy, isa);
    }
    return ways;
}

/// The number of the first float that differs in its bits; that of floats where none does.
size_t first_difference(const Framebuffer &a, const Framebuffer &b) {
    const size_t count = size_t{3} * a.width_px() * a.height_px();
    for (size_t i = 0; i < count; ++i) {
        if (std::memcmp(a.radiance() + i, b.radiance() + i, sizeof(float)) != 0) return i;
    }
    return count;
}

class EveryOddScene : public testing::TestWithParam<OddScene> {};

TEST_P(EveryOddScene, looks_the_same_with_every_kernel_at_every_size) {
    const auto scene = GetParam().make();
    const auto tree = Accel::build(scene, {AccelKind::kdtree}), hierarchy = Accel::build(scene, {AccelKind::bvh});
#ifdef GLINT_SANITIZED
    const std::pair<uint32_t, uint32_t> sizes[] = {{1, 1}, {17, 5}};
#else
    const std::pair<uint32_t, uint32_t> sizes[] = {{1, 1},  {2, 3},  {5, 4},   {16, 16},
                                                   {17, 5}, {3, 33}, {33, 17}, {90, 70}};
#endif
    for (const auto &[width, height] : sizes) {
        const Picture expected = picture_of(tree, Isa::scalar, width, height, GetParam().depth);
        for (const auto &[accel, isa] : every_way(tree, hierarchy)) {
            const Picture found = picture_of(accel, isa, width, height, GetParam().depth);
            const size_t i = first_difference(found.pixels, expected.pixels);
            const auto where = ::testing::Message() << isa_name(isa) << ", " << accel_kind_name(accel->kind()) << ", "
                                                    << width << " x " << height;
            EXPECT_EQ(i, size_t{3} * width * height)
                << where << ": channel " << i % 3 << " of pixel " << i / 3 << " is " << found.pixels.radiance()[i]
                << " instead of " << expected.pixels.radiance()[i];
            EXPECT_EQ(found.pixels.pixel_hash(), expected.pixels.pixel_hash()) << where;
            EXPECT_EQ(found.statistics.primary_rays, expected.statistics.primary_rays) << where;
            EXPECT_EQ(found.statistics.shadow_rays, expected.statistics.shadow_rays) << where;
            EXPECT_EQ(found.statistics.secondary_rays, expected.statistics.secondary_rays) << where;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(scenes, EveryOddScene, testing::ValuesIn(odd_scenes),
                         [](const auto &test) { return std::string(test.param.name); });

TEST(OddScenes, show_what_they_are_for) {
    const auto share_of = [](const std::shared_ptr<const Scene> &scene, uint32_t depth, const auto &counts) {
        const Framebuffer picture = render(scene, 64, 48, depth);
        int found = 0;
        for (uint32_t y = 0; y < 48; ++y) {
            for (uint32_t x = 0; x < 64; ++x) found += counts(pixel(picture, x, y)) ? 1 : 0;
        }
        return found / (64.0 * 48.0);
    };
    const auto is_background = [](const Color &c) { return c == Color(0.1f, 0.1f, 0.2f); };
    EXPECT_EQ(share_of(looking_away(), 3, is_background), 1.0);
    EXPECT_GT(share_of(one_triangle(), 0, is_background), 0.5);
    EXPECT_LT(share_of(inside_a_mesh(), 5, is_background), 0.01);
    for (const float unit : {1e9f, 1e-6f}) EXPECT_GT(share_of(of_size(unit), 0, is_background), 0.1);
    for (const float unit : {1e9f, 1e-6f}) EXPECT_LT(share_of(of_size(unit), 0, is_background), 0.9);
    const auto is_highlight = [](const Color &c) { return c.r > 0.0f && c != Color(0.1f, 0.1f, 0.2f) && c.r < 0.89f; };
    EXPECT_GT(share_of(many_exponents(), 0, is_highlight), 0.2);

    const auto rays = picture_of(Accel::build(branching()), Isa::scalar, 64, 48, 8).statistics;
    EXPECT_GT(rays.secondary_rays, 5 * rays.primary_rays);
}

} // namespace
} // namespace glint::test
