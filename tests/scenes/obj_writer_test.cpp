// OBJ text: what the numbers look like, and that a file is replaced whole or not at all.
#include "generate/obj_writer.hpp"

#include <gtest/gtest.h>

#include "imageio/temporary_folder.hpp"
#include "scenes/scene_folder.hpp"

namespace glint::scenes {
namespace {

using ObjWriter = test::TemporaryFolder;

NamedMesh small_mesh() {
    NamedMesh named{"small.obj", "Small.", {}};
    named.mesh.add_vertex({0.0, -0.5, 12.0});
    named.mesh.add_vertex({0.00001, -0.000001, 1.0 / 3.0});
    named.mesh.add_vertex({-123456.78901, 0.999999, -2.50});
    named.mesh.add_triangle(0, 1, 2);
    return named;
}

TEST_F(ObjWriter, writes_at_most_five_decimals_and_no_trailing_zeros) {
    EXPECT_EQ(obj_text(small_mesh()), "# Small.\n"
                                      "# Made by glint_scenes (scenes/generate): edit that, not this.\n"
                                      "v 0 -0.5 12\n"
                                      "v 0.00001 0 0.33333\n"
                                      "v -123456.78901 1 -2.5\n"
                                      "f 1 2 3\n");
}

TEST_F(ObjWriter, replaces_the_whole_file_and_leaves_no_temporary) {
    const auto path = in_folder("small.obj");
    std::ofstream(path) << std::string(100000, 'x');
    write_obj(small_mesh(), path.parent_path());
    EXPECT_EQ(test::text_of(path), obj_text(small_mesh()));
    EXPECT_EQ(listing(), std::vector<std::string>{"small.obj"});
}

TEST_F(ObjWriter, says_so_where_the_folder_is_missing) {
    EXPECT_THROW(write_obj(small_mesh(), in_folder("missing")), std::filesystem::filesystem_error);
}

} // namespace
} // namespace glint::scenes
