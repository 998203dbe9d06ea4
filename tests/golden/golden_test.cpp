// The pictures themselves: every scene keeps its hashes, on every machine, for every number of threads.
#include <cmath>
#include <fstream>
#include <iomanip>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "support/picture.hpp"

namespace glint::test {
namespace {

const std::filesystem::path scenes = std::filesystem::path(GLINT_SOURCE_DIR) / "scenes" / "sdl";

struct Golden {
    std::string scene;
    uint32_t width, height, depth;
    std::string pixels, radiance;
};

std::ostream &operator<<(std::ostream &out, const Golden &golden) {
    return out << golden.scene;
}

std::vector<Golden> golden_table() {
    std::ifstream file(std::filesystem::path(GLINT_SOURCE_DIR) / "tests" / "golden" / "pictures.txt");
    std::vector<Golden> table;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        Golden golden;
        std::istringstream words(line);
        words >> golden.scene >> golden.width >> golden.height >> golden.depth >> golden.pixels >> golden.radiance;
        table.push_back(golden);
    }
    return table;
}

std::string hex(uint64_t hash) {
    std::ostringstream text;
    text << std::hex << std::setfill('0') << std::setw(16) << hash;
    return text.str();
}

class EveryPicture : public testing::TestWithParam<Golden> {};

TEST_P(EveryPicture, keeps_its_hashes) {
    const Golden &golden = GetParam();
    const auto file = read_scene(scenes / (golden.scene + ".sdl"));
    ASSERT_TRUE(file) << file.error().text();
    const Framebuffer picture = render(file->scene, golden.width, golden.height, golden.depth, 2);
    std::ostringstream line;
    line << golden.scene << ' ' << golden.width << ' ' << golden.height << ' ' << golden.depth << ' '
         << hex(picture.pixel_hash()) << ' ' << hex(picture.radiance_hash());
    EXPECT_EQ(hex(picture.pixel_hash()), golden.pixels) << "now: " << line.str();
    EXPECT_EQ(hex(picture.radiance_hash()), golden.radiance) << "now: " << line.str();

    // A picture worth keeping is not black and not of one colour.
    std::set<uint32_t> colors;
    uint64_t bright = 0;
    const uint32_t count = golden.width * golden.height;
    for (uint32_t i = 0; i < count; ++i) {
        const uint8_t *p = picture.rgba8() + size_t{i} * 4;
        colors.insert(uint32_t{p[0]} << 16 | uint32_t{p[1]} << 8 | p[2]);
        bright += p[0] + p[1] + p[2] > 60;
    }
    EXPECT_GT(colors.size(), 100u);
    EXPECT_GT(bright, count / 4);
}

INSTANTIATE_TEST_SUITE_P(pictures, EveryPicture, testing::ValuesIn(golden_table()), [](const auto &test) {
    return test.param.scene + "_" + std::to_string(test.param.width) + "x" + std::to_string(test.param.height) +
           "_depth_" + std::to_string(test.param.depth);
});

// Figure 5 of the paper: the same room with 0, 1 and 2 recursive rays.
class Figure5 : public testing::Test {
protected:
    static Framebuffer at_depth(uint32_t depth) {
        auto file = read_scene(scenes / "cornell.sdl");
        if (!file) throw std::runtime_error(file.error().text());
        return render(file->scene, 256, 256, depth);
    }
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
