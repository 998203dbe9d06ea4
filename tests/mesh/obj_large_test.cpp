// OBJ files of a size that would show a quadratic reader or a wasteful one.
#include <string>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/cpu_time.hpp"
#include "support/written_files.hpp"

namespace glint::test {
namespace {

class LargeObjs : public WrittenFiles {
protected:
    /// Reads the text and fails the test where that takes far longer than it ever should.
    Result<MeshFile> read(std::string_view text) const {
        const auto file = write("large.obj", text);
        const CpuTime time;
        auto mesh = read_obj(file);
        EXPECT_LT(time.seconds(), 30.0);
        return mesh;
    }
};

TEST_F(LargeObjs, with_a_million_triangles_are_read) {
    constexpr int side = 708; // 707^2 cells of two triangles
    std::string text;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            text += "v " + std::to_string(x * 0.01) + ' ' + std::to_string(y * 0.01) + ' ' +
                    std::to_string((x * 7 + y * 13) % 10 * 0.1) + '\n';
        }
    }
    for (int y = 1; y < side; ++y) {
        for (int x = 1; x < side; ++x) {
            const std::string a = std::to_string((y - 1) * side + x), b = std::to_string((y - 1) * side + x + 1);
            const std::string c = std::to_string(y * side + x), d = std::to_string(y * side + x + 1);
            text += "f " + a + ' ' + b + ' ' + d + "\nf " + a + ' ' + d + ' ' + c + '\n';
        }
    }
    const auto mesh = read(text);
    ASSERT_TRUE(mesh.ok()) << mesh.error().text();
    EXPECT_EQ(mesh->mesh->positions.size(), size_t{side} * side);
    EXPECT_EQ(mesh->mesh->triangles.size(), size_t{2} * (side - 1) * (side - 1));
    EXPECT_EQ(mesh->mesh->triangles.back(), (Triangle{side * side - side - 2, side * side - 1, side * side - 2}));
}

TEST_F(LargeObjs, may_have_a_polygon_of_a_hundred_thousand_corners) {
    constexpr int corners = 100000;
    std::string text, face = "f";
    for (int i = 0; i < corners / 2; ++i) text += "v " + std::to_string(i) + ' ' + std::to_string(i % 2) + " 0\n";
    for (int i = corners / 2; i-- > 0;) text += "v " + std::to_string(i) + ' ' + std::to_string(2 + i % 2) + " 0\n";
    for (int i = 1; i <= corners; ++i) face += ' ' + std::to_string(i);
    const auto mesh = read(text + face + '\n');
    ASSERT_TRUE(mesh.ok()) << mesh.error().text();
    EXPECT_EQ(mesh->mesh->triangles.size(), size_t{corners} - 2);
}

TEST_F(LargeObjs, may_have_endless_lines) {
    const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_TRUE(read('#' + std::string(10'000'000, 'x') + '\n' + good).ok());
    EXPECT_TRUE(read(good + "f 1 2 3" + std::string(10'000'000, ' ') + '\n').ok());
    const auto token = read(good + "v 0 0 " + std::string(10'000'000, '7'));
    ASSERT_FALSE(token.ok());
    EXPECT_LT(token.error().text().size(), 1000u);
    std::string continued = "g a";
    for (int i = 0; i < 1'000'000; ++i) continued += " \\\n";
    EXPECT_TRUE(read(continued + '\n' + good).ok());
    std::string faults = good + "f";
    for (int i = 0; i < 1'000'000; ++i) faults += " x";
    const auto many = read(faults);
    ASSERT_FALSE(many.ok());
    EXPECT_EQ(many.error().diagnostics.back().message, "and 999901 more problems");
}

} // namespace
} // namespace glint::test
