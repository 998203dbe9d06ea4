// Broken in random ways, an OBJ file and its library give a model or an error, and never anything else.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "mesh/model_files.hpp"
#include "support/mutate.hpp"

namespace glint::test {
namespace {

constexpr std::string_view good_obj =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 -1.5e-1\nvt 0 0\nvt 1 0.5 0\n"
    "vn 0 0 1\nvn 0 1e-3 1\nusemtl red\nf 1/1/1 2/2/2 3/1/-1 4/2/1\nusemtl glass one\n"
    "f -1//1 2/1/2 3/1\nf 1 2 3 # last\n";
constexpr std::string_view good_mtl =
    "# two\nnewmtl red\nKa 0 0 0\nKd 0.8 0.1 .1\nKs 0.5 0.5 0.25\nNs 50\nKe 0 0 0\n"
    "map_Kd -s 1 1 -o 0 0 0 a.png\nnewmtl glass one\nTr 0.75\nd 0.25\nNi 1.5\nillum 4\n";

bool fits(const Mesh &mesh) {
    const auto all_fit = [&](const std::vector<Triangle> &corners, size_t count) {
        return (corners.empty() || corners.size() == mesh.triangles.size()) &&
               std::all_of(corners.begin(), corners.end(), [&](const Triangle &t) {
                   return (t.a == no_corner && t.b == no_corner && t.c == no_corner) ||
                          (t.a < count && t.b < count && t.c < count);
               });
    };
    return !mesh.triangles.empty() && all_fit(mesh.triangles, mesh.positions.size()) &&
           all_fit(mesh.normal_corners, mesh.normals.size()) && all_fit(mesh.texcoord_corners, mesh.texcoords.size());
}

class MutatedModels : public ModelFiles {
protected:
    void expect_models_and_errors(bool mutate_obj) const {
        CountedTextures textures;
        const ReadOptions options = textures.options();
        write("a.png", "");
        write("a.obj", good_obj);
        write("a.mtl", good_mtl);
        Random random(mutate_obj ? 1 : 2);
        int models = 0, errors = 0;
        for (int i = 0; i < 1200; ++i) {
            const std::string obj = mutate_obj ? mutated(good_obj, random) : std::string(good_obj);
            const std::string mtl = mutate_obj ? std::string(good_mtl) : mutated(good_mtl, random);
            write(mutate_obj ? "a.obj" : "a.mtl", mutate_obj ? obj : mtl);
            const auto model = read_model(in_folder("a.obj"), options);
            if (model.ok()) {
                ++models;
                SceneBuilder builder;
                for (const ModelPart &part : model->parts) {
                    ASSERT_TRUE(fits(*part.mesh)) << obj;
                    builder.add_object({part.material_name, part.mesh, part.material});
                }
                const auto scene = builder.build();
                ASSERT_TRUE(scene.ok()) << scene.error().text() << "\n" << obj << mtl;
            } else {
                ++errors;
                ASSERT_FALSE(model.error().text().empty());
                ASSERT_EQ(model.error().text().find("differently"), std::string::npos) << obj << mtl;
            }
        }
        EXPECT_GT(models, 100);
        EXPECT_GT(errors, 100);
    }
};

TEST_F(MutatedModels, give_a_model_or_an_error) {
    expect_models_and_errors(true);
}

TEST_F(MutatedModels, with_broken_libraries_give_a_model_or_an_error) {
    expect_models_and_errors(false);
}

} // namespace
} // namespace glint::test
