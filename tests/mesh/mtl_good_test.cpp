// What materials and textures good MTL files become.
#include <string>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "mesh/model_files.hpp"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

using MtlFiles = ModelFiles;

TEST_F(MtlFiles, are_read_to_the_last_bit) {
    const Material material = material_of("# all there is\r\n  newmtl m  \r\nKa 0 0 0\nKd 0.8 0.125 1e-1 # red\n"
                                          "\tKs\t0.5 0.25 0\nKe 0 0 0\nNs 96.5\nNi 1.45\nd 0.25\nTr 0.75\nillum 2\n"
                                          "Tf 1 1.0 1\nsharpness 60\n");
    EXPECT_EQ(material.color, Color(0.8f, 0.125f, 0.1f));
    EXPECT_EQ(material.ambient, 1.0f);
    EXPECT_EQ(material.diffuse, 1.0f);
    EXPECT_EQ(material.specular, 0.5f);
    EXPECT_EQ(material.highlight_color, Color(1, 0.5f, 0));
    EXPECT_EQ(material.specular_exponent, 96.5f);
    EXPECT_EQ(material.transmission, 0.75f);
    EXPECT_EQ(material.ior, 1.45f);
    EXPECT_EQ(material.reflection, 0.0f);
    EXPECT_FALSE(material.adds_to_local);
    EXPECT_EQ(material.texture, nullptr);
}

TEST_F(MtlFiles, have_defaults_for_what_they_do_not_say) {
    const Material material = material_of("newmtl m\n");
    EXPECT_EQ(material.color, Color(1.0f));
    EXPECT_EQ(material.specular, 0.0f);
    EXPECT_EQ(material.highlight_color, Color(1.0f));
    EXPECT_EQ(material.specular_exponent, 1.0f);
    EXPECT_EQ(material.transmission, 0.0f);
    EXPECT_EQ(material.ior, 1.0f);
    EXPECT_EQ(material_of("newmtl m\nKs 0 0 0\n").highlight_color, Color(1.0f));
}

TEST_F(MtlFiles, may_say_transparency_either_way) {
    EXPECT_EQ(material_of("newmtl m\nd 0.75\n").transmission, 0.25f);
    EXPECT_EQ(material_of("newmtl m\nTr 0.25\n").transmission, 0.25f);
    EXPECT_EQ(material_of("newmtl m\nTr 0\nd 1\n").transmission, 0.0f);
    EXPECT_EQ(material_of("newmtl m\nd 0\nTr 1\n").transmission, 1.0f);
    EXPECT_EQ(material_of("newmtl m\nTr 0.667\nd 0.33\n").transmission, 1.0f - 0.33f) << "rounded by an exporter";
}

TEST_F(MtlFiles, may_leave_the_index_of_refraction_zero_where_nothing_shines_through) {
    EXPECT_EQ(material_of("newmtl m\nNi 0\nd 1\n").ior, 1.0f);
}

TEST_F(MtlFiles, may_write_numbers_in_odd_ways) {
    const std::string zeroes(400, '0');
    const Material material = material_of("newmtl m\nKd 1" + zeroes + "e-400 0." + zeroes + "5e400 +.25\nNs 1E3\n");
    EXPECT_EQ(material.color, Color(1, 0.5f, 0.25f));
    EXPECT_EQ(material.specular_exponent, 1000.0f);
}

TEST_F(MtlFiles, may_end_lines_as_any_system_does) {
    EXPECT_EQ(material_of("\xef\xbb\xbfnewmtl m\rKd 1 0 \\\r\n 0\r").color, Color(1, 0, 0));
}

TEST_F(MtlFiles, may_have_names_with_blanks_and_signs) {
    write("a.mtl", "newmtl Material #25\nKd 1 0 0\nnewmtl Material #26\nKd 0 1 0\n");
    const ModelFile model = read("mtllib a.mtl\n" + std::string(four_vertices) + "usemtl Material #26\nf 1 2 3\n");
    EXPECT_EQ(model.parts.at(0).material.color, Color(0, 1, 0));
}

TEST_F(MtlFiles, may_be_several_and_the_first_that_has_a_material_counts) {
    write("a.mtl", "newmtl one\nKd 1 0 0\n");
    write("b.mtl", "newmtl one\nKd 0 1 0\nnewmtl two\nKd 0 0 1\n");
    write("with blanks.mtl", "newmtl three\nKd 1 1 0\n");
    const ModelFile model = read("mtllib a.mtl  b.mtl a.mtl # both\n" + std::string(four_vertices) +
                                 "usemtl one\nf 1 2 3\nusemtl two\nf 1 2 3\nusemtl three\nf 1 2 3\n"
                                 "mtllib with blanks.mtl\nmtllib ./b.mtl\n");
    EXPECT_EQ(model.parts.at(0).material.color, Color(1, 0, 0));
    EXPECT_EQ(model.parts.at(1).material.color, Color(0, 0, 1));
    EXPECT_EQ(model.parts.at(2).material.color, Color(1, 1, 0));
    EXPECT_EQ(model.files, (std::vector<fs::path>{in_folder("model.obj"), in_folder("a.mtl"), in_folder("b.mtl"),
                                                  in_folder("with blanks.mtl")}));
}

TEST_F(MtlFiles, warn_of_what_has_no_place_in_a_material) {
    const ModelFile model = read_with("newmtl m\nKe 0 0.5 0\nmap_Bump a.png\nPr 0.5\nTf xyz 1\n");
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0].text(), in_folder("model.mtl").string() +
                                            ":2:1: warning: 4 lines of materials' properties that Glint does not have "
                                            "('Ke' first)\n    Ke 0 0.5 0\n    ^");
}

TEST_F(MtlFiles, warn_of_unknown_lines_once) {
    const ModelFile model = read_with("newmtl m\n  kd 1 0 0\nKd 1 1 1\nfoo\nbar 1\n");
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0].line, 2u);
    EXPECT_EQ(model.warnings[0].column, 3u);
    EXPECT_EQ(model.warnings[0].message, "3 lines of a kind that is not read ('kd' first)");
    EXPECT_EQ(model.warnings[0].hint, "did you mean 'Kd'?");
}

TEST_F(MtlFiles, without_a_material_are_warned_of) {
    write("empty.mtl", "# nothing\n");
    const ModelFile model = read("mtllib empty.mtl\n" + std::string(four_vertices) + "f 1 2 3\n");
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0].message, "the library has no material ('newmtl')");
}

TEST_F(MtlFiles, have_textures_that_are_read_once_each) {
    CountedTextures textures;
    write("maps/wood.png", "");
    fs::create_symlink("wood.png", in_folder("maps/same.png"));
    write("maps/a #1.png", "");
    write("maps/a.mtl", "newmtl a\nmap_Kd wood.png\nnewmtl b\nKd 0.5 0.5 0.5\nmap_Kd ../maps/same.png\n"
                        "newmtl c\nmap_Kd   a #1.png  \nnewmtl unused\nmap_Kd missing.png\n");
    const ModelFile model = read("mtllib maps/a.mtl\n" + std::string(four_vertices) +
                                     "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n"
                                     "usemtl c\nf 1/1 2/1 3/1\nusemtl a\nf 2/1 3/1 4/1\n",
                                 textures.options());
    EXPECT_EQ(textures.calls, 2);
    ASSERT_EQ(model.parts.size(), 3u);
    ASSERT_NE(model.parts[0].material.texture, nullptr);
    EXPECT_EQ(model.parts[0].material.color, Color(1.0f));
    EXPECT_EQ(model.parts[1].material.texture, model.parts[0].material.texture);
    EXPECT_EQ(model.parts[1].material.color, Color(0.5f));
    EXPECT_EQ(model.parts[2].material.texture->texels.at(0).x, 2e-3f);
    EXPECT_TRUE(model.warnings.empty());
    ASSERT_EQ(model.files.size(), 4u);
    EXPECT_EQ(fs::canonical(model.files[2]), fs::canonical(in_folder("maps/wood.png")));
    EXPECT_EQ(fs::canonical(model.files[3]), fs::canonical(in_folder("maps/a #1.png")));
}

TEST_F(MtlFiles, lie_anywhere_up_to_the_scene_root) {
    CountedTextures textures;
    ReadOptions options = textures.options();
    options.scene_root = in_folder("");
    write("lib/a.mtl", "newmtl m\nmap_Kd t/x.png\n");
    write("t/x.png", "");
    const auto model = read_model(write("meshes/deep/a.obj", "mtllib lib/a.mtl\n" + std::string(four_vertices) +
                                                                 "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\n"),
                                  options);
    ASSERT_TRUE(model.ok()) << model.error().text();
    EXPECT_EQ(fs::canonical(model->files.at(1)), fs::canonical(in_folder("lib/a.mtl")));
    EXPECT_EQ(fs::canonical(model->files.at(2)), fs::canonical(in_folder("t/x.png")));
}

TEST_F(MtlFiles, may_give_textures_options_that_change_nothing) {
    CountedTextures textures;
    write("wood.png", "");
    write("-s", "");
    write("a.mtl", "newmtl a\nmap_Kd -s 1 1.0 wood.png\nnewmtl b\nmap_Kd -o 0 0 0 -mm 0 1 -blendu on -clamp off "
                   "-imfchan m -texres 512 -bm 1 -type sphere -colorspace sRGB wood.png\n");
    const ModelFile model = read("mtllib a.mtl\n" + std::string(four_vertices) +
                                     "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n",
                                 textures.options());
    EXPECT_EQ(textures.calls, 1);
    EXPECT_NE(model.parts.at(1).material.texture, nullptr);
    EXPECT_TRUE(model.warnings.empty());
}

TEST_F(MtlFiles, warn_of_options_that_should_change_a_texture) {
    CountedTextures textures;
    write("wood.png", "");
    const std::pair<const char *, uint32_t> effective[] = {{"-s 2", 8},         {"-s 1 1 0.5", 8}, {"-o 0 0.1", 8},
                                                           {"-mm 0.5 1", 8},    {"-t 1 1 1", 8},   {"-clamp on", 8},
                                                           {"-bm 1 -cc on", 14}};
    for (const auto &[option, column] : effective) {
        write("model.mtl", "newmtl m\nmap_Kd " + std::string(option) + " wood.png\n");
        const ModelFile model =
            read("mtllib model.mtl\n" + std::string(four_vertices) + "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\n",
                 textures.options());
        EXPECT_NE(model.parts.at(0).material.texture, nullptr) << option;
        ASSERT_EQ(model.warnings.size(), 1u) << option;
        EXPECT_EQ(model.warnings[0].line, 2u);
        EXPECT_EQ(model.warnings[0].column, column) << option;
        EXPECT_NE(model.warnings[0].message.find("is left aside: the texture shows as if it were not there"),
                  std::string::npos);
    }
}

TEST_F(MtlFiles, warn_once_where_nobody_reads_textures) {
    write("x.png", "");
    write("a.mtl", "newmtl a\nmap_Kd x.png\nnewmtl b\nmap_Kd x.png\n");
    const ModelFile model = read("mtllib a.mtl\n" + std::string(four_vertices) +
                                 "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n");
    EXPECT_EQ(model.parts.at(0).material.texture, nullptr);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0].text(), in_folder("a.mtl").string() +
                                            ":2:8: warning: the texture 'x.png' is left aside, and so are all others\n"
                                            "    map_Kd x.png\n           ^\n    this program reads no image files");
}

TEST_F(MtlFiles, warn_of_textures_on_faces_without_texture_coordinates) {
    CountedTextures textures;
    write("x.png", "");
    const ModelFile model = read_with("newmtl m\nmap_Kd x.png\n", textures.options());
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_EQ(model.warnings[0].line, 2u);
    EXPECT_EQ(model.warnings[0].column, 8u);
    EXPECT_EQ(model.warnings[0].message, "the material 'm' has a texture, and its faces have no texture coordinates");
}

} // namespace
} // namespace glint::test
