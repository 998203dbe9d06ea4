// Broken in random ways, an OBJ file gives a mesh or an error, and never anything else.
#include <string>

#include <gtest/gtest.h>

#include "mesh/read_obj.hpp"
#include "support/mutate.hpp"
#include "support/text_in_memory.hpp"

namespace glint::test {
namespace {

constexpr std::string_view good = "# a house\nmtllib house.mtl\no house\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 -1.5e-1\n"
                                  "v 0.5 1.5 0 1 0 0\nvt 0 0\nvn 0 0 1\ng walls\nusemtl red\ns off\nf 1 2 3 4\r\n"
                                  "f -1//1 4/1/1 3/1\nf 1 2 3 \\\n 5 4\nl 1 2\nvp 0.1\nf 1 2 5 # roof\n";

TEST(MutatedObjs, give_a_mesh_or_an_error) {
    Random random(2013);
    int meshes = 0, errors = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::string text = mutated(good, random);
        const auto mesh = read_obj_text(text_in_memory(text), "mutated.obj", {});
        if (mesh.ok()) {
            ++meshes;
            const size_t count = mesh->mesh->positions.size();
            ASSERT_FALSE(mesh->mesh->triangles.empty());
            for (const Triangle &t : mesh->mesh->triangles)
                ASSERT_TRUE(t.a < count && t.b < count && t.c < count) << text;
        } else {
            ++errors;
            ASSERT_FALSE(mesh.error().text().empty());
            // The second opinion must never be the one to find something: its pass would have missed a case.
            ASSERT_EQ(mesh.error().text().find("differently"), std::string::npos) << text;
        }
    }
    EXPECT_GT(meshes, 500);
    EXPECT_GT(errors, 500);
}

} // namespace
} // namespace glint::test
