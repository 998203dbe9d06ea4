// The pictures themselves: every scene keeps its hashes, on every machine, for every instruction set and any number of
// threads.
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "golden/golden_table.hpp"
#include "support/picture.hpp"

namespace glint::test {
namespace {

const std::filesystem::path source = GLINT_SOURCE_DIR;
const std::filesystem::path scenes = source / "scenes" / "sdl";
const std::filesystem::path table_file = source / "tests" / "golden" / "pictures.txt";

/// A scene; read once, however many pictures there are of it.
std::shared_ptr<const Scene> scene_named(const std::string &name) {
    static std::map<std::string, std::shared_ptr<const Scene>> known;
    std::shared_ptr<const Scene> &scene = known[name];
    if (!scene) {
        const auto file = read_scene(scenes / (name + ".sdl"));
        if (!file) throw std::runtime_error(file.error().text());
        scene = file->scene;
    }
    return scene;
}

/// What is built for it; also once.
std::shared_ptr<const Accel> accel_of(const std::string &scene, AccelKind kind = AccelKind::automatic) {
    static std::map<std::pair<std::string, AccelKind>, std::shared_ptr<const Accel>> known;
    std::shared_ptr<const Accel> &accel = known[{scene, kind}];
    if (!accel) accel = Accel::build(scene_named(scene), {kind});
    return accel;
}

/// A picture worth keeping is not black and not of one colour.
void expect_something_to_see(const Framebuffer &picture) {
    std::set<uint32_t> colors;
    uint64_t bright = 0;
    const uint32_t count = picture.width_px() * picture.height_px();
    for (uint32_t i = 0; i < count; ++i) {
        const uint8_t *p = picture.rgba8() + size_t{i} * 4;
        colors.insert(uint32_t{p[0]} << 16 | uint32_t{p[1]} << 8 | p[2]);
        bright += p[0] + p[1] + p[2] > 60;
    }
    EXPECT_GT(colors.size(), 100u);
    EXPECT_GT(bright, count / 4);
}

class EveryPicture : public testing::TestWithParam<Golden> {};

TEST_P(EveryPicture, keeps_its_hashes_for_every_instruction_set_and_number_of_threads) {
    const Golden &golden = GetParam();
    const auto accel = accel_of(golden.scene);
    const bool is_large = accel->statistics().triangles > 100'000;
    const std::vector<unsigned> thread_counts = is_large ? std::vector{2u} : std::vector{1u, 2u, 3u, 8u};
    for (const Isa isa : available_isas()) {
        for (const unsigned threads : thread_counts) {
            const Framebuffer picture = render(accel, golden.width, golden.height, golden.depth, {threads, isa});
            EXPECT_EQ(hashes_of(picture), golden.hashes)
                << isa_name(isa) << ", " << threads << " threads; the line of the table is: " << golden;
        }
    }
    // The other structure finds the same.
    const AccelKind other = accel->kind() == AccelKind::kdtree ? AccelKind::bvh : AccelKind::kdtree;
    EXPECT_EQ(
        hashes_of(render(accel_of(golden.scene, other), golden.width, golden.height, golden.depth, {.threads = 2})),
        golden.hashes)
        << accel_kind_name(other);
    constexpr uint32_t fewest_pixels_to_judge = 1000;
    if (golden.width * golden.height < fewest_pixels_to_judge) return;
    expect_something_to_see(render(accel, golden.width, golden.height, golden.depth, {.threads = 2}));
}

INSTANTIATE_TEST_SUITE_P(pictures, EveryPicture, testing::ValuesIn(golden_table(table_file)), [](const auto &test) {
    return test.param.scene + "_" + std::to_string(test.param.width) + "x" + std::to_string(test.param.height) +
           "_depth_" + std::to_string(test.param.depth);
});

TEST(Cornell, is_the_same_a_hundred_times_over_with_eight_threads) {
    const auto accel = accel_of("cornell");
    const uint64_t expected = render(accel, 128, 128, 2, {1, Isa::scalar}).radiance_hash();
    for (const Isa isa : available_isas()) {
        Renderer renderer(accel, {8, isa});
        auto picture = Framebuffer::create(128, 128);
        RenderOptions options;
        options.max_depth = 2;
        for (int run = 0; run < 100; ++run) {
            ASSERT_TRUE(renderer.render(*picture, options));
            ASSERT_EQ(picture->radiance_hash(), expected) << isa_name(isa) << ", run " << run;
        }
    }
}

// Figure 5 of the paper: the same room with 0, 1 and 2 recursive rays.
class Figure5 : public testing::Test {
protected:
    static Framebuffer at_depth(uint32_t depth) { return render(accel_of("cornell"), 256, 256, depth, {.threads = 2}); }
};

TEST_F(Figure5, without_recursion_the_walls_have_their_own_colours) {
    const Framebuffer picture = at_depth(0);
    const Color left = pixel(picture, 8, 128), right = pixel(picture, 247, 128), back = pixel(picture, 128, 100);
    EXPECT_GT(left.r, 5 * left.g + 0.01f);
    EXPECT_GT(right.g, 5 * right.r + 0.01f);
    EXPECT_FLOAT_EQ(back.r, back.g);
    EXPECT_FLOAT_EQ(back.g, back.b);
}

TEST_F(Figure5, one_ray_mirrors_the_room_in_left_right_and_back_wall) {
    const Framebuffer zero = at_depth(0), one = at_depth(1);
    // The lamp's image in the back wall has an edge; the wall itself has none there.
    EXPECT_GT(pixel(one, 128, 66).r - pixel(one, 128, 62).r, 0.4f);
    EXPECT_LT(std::abs(pixel(zero, 128, 66).r - pixel(zero, 128, 62).r), 0.1f);
    // The floor does not reflect: its pixels do not change.
    EXPECT_EQ(pixel(one, 128, 245), pixel(zero, 128, 245));
}

TEST_F(Figure5, two_rays_mirror_the_mirrors) {
    const Framebuffer one = at_depth(1), two = at_depth(2);
    uint32_t changed = 0;
    for (uint32_t y = 0; y < 256; ++y) {
        for (uint32_t x = 0; x < 256; ++x) changed += pixel(one, x, y) != pixel(two, x, y);
    }
    EXPECT_GT(changed, 256u * 256u / 20);
    EXPECT_LT(changed, 256u * 256u / 2);
}

} // namespace
} // namespace glint::test
