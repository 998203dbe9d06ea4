// Models of a size that would show a quadratic reader.
#include <string>

#include <gtest/gtest.h>

#include "mesh/model_files.hpp"
#include "support/cpu_time.hpp"

namespace glint::test {
namespace {

class LargeModels : public ModelFiles {
protected:
    /// Reads the text and fails the test where that takes far longer than it ever should.
    [[nodiscard]] Result<ModelFile> read_soon(std::string_view text) const {
        const auto file = write("large.obj", text);
        const CpuTime time;
        auto model = read_model(file);
        EXPECT_LT(time.seconds(), 30.0);
        return model;
    }
};

TEST_F(LargeModels, may_have_a_hundred_thousand_materials) {
    constexpr int count = 100'000;
    std::string obj = "mtllib many.mtl\n", mtl;
    for (int i = 0; i < count; ++i) obj += "v " + std::to_string(i) + " 0 0\n";
    obj += "v 0 1 0\nv 0 2 0\nvn 0 0 1\nvt 0 0\n";
    for (int i = 0; i < count; ++i) {
        const std::string name = std::to_string(i);
        mtl += "newmtl " + name + "\nKd 0.5 0.5 0.5\nNs 10\n";
        obj += "usemtl " + name + "\nf " + std::to_string(1 + i) + "/1/1 -1/1/1 -2/1/1\n";
    }
    write("many.mtl", mtl);
    const auto model = read_soon(obj);
    ASSERT_TRUE(model.ok()) << model.error().text();
    EXPECT_EQ(model->parts.size(), size_t{count} - 1) << "the first triangle has no area";
    EXPECT_EQ(model->parts.back().mesh->positions.size(), 3u);
}

TEST_F(LargeModels, may_miss_a_hundred_thousand_materials) {
    std::string obj(four_vertices), mtl;
    for (int i = 0; i < 100'000; ++i) {
        obj += "usemtl material" + std::to_string(i) + "\nf 1 2 3\n";
        mtl += "newmtl thing" + std::to_string(i) + "\n";
    }
    write("many.mtl", mtl);
    const auto model = read_soon("mtllib many.mtl\n" + obj);
    ASSERT_FALSE(model.ok());
    EXPECT_EQ(model.error().diagnostics.back().message, "and 99900 more problems");
}

TEST_F(LargeModels, may_name_a_library_endlessly) {
    write("a.mtl", "newmtl m\n");
    std::string obj(four_vertices), names = "mtllib";
    for (int i = 0; i < 20'000; ++i) obj += "mtllib a.mtl\n", names += " a.mtl";
    const auto model = read_soon(obj + names + "\nusemtl m\nf 1 2 3\n");
    ASSERT_TRUE(model.ok()) << model.error().text();
    EXPECT_EQ(model->files.size(), 2u);
}

TEST_F(LargeModels, may_have_endless_lines_in_their_libraries) {
    const auto expect_refused = [&](const std::string &line) {
        write("a.mtl", "newmtl m\n" + line + "\n");
        const auto model = read_soon("mtllib a.mtl\nusemtl m\n" + std::string(four_vertices) + "f 1 2 3\n");
        ASSERT_FALSE(model.ok());
        EXPECT_LT(model.error().text().size(), 20'000u);
    };
    expect_refused("Kd 0 0 " + std::string(1'000'000, '7'));
    std::string many = "Kd";
    for (int i = 0; i < 1'000'000; ++i) many += " x";
    expect_refused(many);
}

TEST_F(LargeModels, of_a_million_triangles_are_read) {
    constexpr int side = 708; // 707^2 cells of two triangles
    std::string text = "vn 0 0 1\n";
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            text += "v " + std::to_string(x) + ' ' + std::to_string(y) + " 0\nvt 0." + std::to_string(x) + " 0." +
                    std::to_string(y) + '\n';
        }
    }
    const auto corner = [](int i) { return ' ' + std::to_string(i) + '/' + std::to_string(i) + "/1"; };
    for (int y = 1; y < side; ++y) {
        for (int x = 1; x < side; ++x) {
            const int d = y * side + x + 1, c = d - 1, b = d - side, a = b - 1;
            text += 'f' + corner(a) + corner(b) + corner(d) + corner(c) + '\n';
        }
    }
    const auto model = read_soon(text);
    ASSERT_TRUE(model.ok()) << model.error().text();
    const Mesh &mesh = *model->parts.at(0).mesh;
    EXPECT_EQ(mesh.triangles.size(), size_t{2} * (side - 1) * (side - 1));
    EXPECT_EQ(mesh.texcoord_corners, mesh.triangles);
    EXPECT_EQ(mesh.normals.size(), 1u);
}

} // namespace
} // namespace glint::test
