// Every way in which an OBJ file's materials are refused, with its words.
#include <string>

#include <sys/stat.h>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "mesh/model_files.hpp"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

/// The text of a library, and the one problem it has.
struct BadMtl {
    const char *name;
    const char *text;
    uint32_t line, column;
    std::string message;
    std::string hint = {};
};

void PrintTo(const BadMtl &bad, std::ostream *out) {
    *out << bad.name;
}

class BadMtls : public ModelFiles, public ::testing::WithParamInterface<BadMtl> {};

TEST_P(BadMtls, are_refused_with_a_place_and_words) {
    const BadMtl &bad = GetParam();
    const fs::path library = write("bad.mtl", bad.text);
    const auto model =
        read_model(write("a.obj", "mtllib bad.mtl\n" + std::string(four_vertices) + "usemtl m\nf 1 2 3\n"));
    ASSERT_FALSE(model.ok());
    const Error &error = model.error();
    ASSERT_EQ(error.diagnostics.size(), 1u) << error.text();
    EXPECT_EQ(error.code, ErrorCode::bad_input);
    const Diagnostic &diagnostic = error.diagnostics[0];
    EXPECT_EQ(diagnostic.severity, Diagnostic::Severity::error);
    EXPECT_EQ(diagnostic.file, library.string());
    EXPECT_EQ(diagnostic.line, bad.line);
    EXPECT_EQ(diagnostic.column, bad.column);
    EXPECT_EQ(diagnostic.message, bad.message);
    EXPECT_EQ(diagnostic.hint, bad.hint);
    EXPECT_FALSE(diagnostic.source_line.empty());
}

const std::string no_library_hint = "mtllib names files that begin their materials with 'newmtl'";

const BadMtl bad_mtls[] = {
    {"nan", "newmtl m\nKd nan 0 0\n", 2, 4, "'nan' is not a finite number"},
    {"inf", "newmtl m\nNs inf\n", 2, 4, "'inf' is not a finite number"},
    {"overflow", "newmtl m\nNs 1e40\n", 2, 4, "'1e40' is too large", "the largest number is 3.4e38"},
    {"comma", "newmtl m\nd 0,5\n", 2, 3, "'0,5' is not a number", "write the decimal point as '.': 0.5"},
    {"junk", "newmtl m\nKs 0 0 1.0x\n", 2, 8, "'1.0x' is not a number: 'x' follows '1.0'"},
    {"glued", "newmtl m\nKd .5.5 0 0\n", 2, 4, "'.5.5' is not a number: it looks like two",
     "put a blank between: .5 .5"},
    {"spectral", "newmtl m\nKd spectral a.rfl 1\n", 2, 4, "Kd is given as 'spectral', expected red, green and blue"},
    {"halo", "newmtl m\nd -halo\n", 2, 3, "'-halo' is not a number"},
    {"bright", "newmtl m\nKd 0 1.5 0\n", 2, 6, "Kd is '1.5', expected a number from 0 to 1"},
    {"negative", "newmtl m\nKs 0 0 -0.1\n", 2, 8, "Ks is '-0.1', expected a number from 0 to 1"},
    {"shiny", "newmtl m\nNs 1e7\n", 2, 4, "Ns is '1e7', expected a number from 0 to 1e+06"},
    {"opaque", "newmtl m\nd 100\n", 2, 3, "d is '100', expected a number from 0 to 1"},
    {"clear", "newmtl m\nTr 1.1\n", 2, 4, "Tr is '1.1', expected a number from 0 to 1"},
    {"dense", "newmtl m\nNi 101\n", 2, 4, "Ni is '101', expected a number from 0 to 100"},
    {"thin", "newmtl m\nNi 0\nd 0.5\n", 2, 4, "Ni is 0, expected a number from 0.01 to 100"},
    {"thin_by_tr", "newmtl m\nTr 0.5\nNi 0.001\nnewmtl n\n", 3, 4, "Ni is 0.001, expected a number from 0.01 to 100"},
    {"one_number", "newmtl m\nKd 0.5\n", 2, 1, "'Kd' takes 3 numbers, found 1"},
    {"four_numbers", "newmtl m\nKd 0 0 0 0\n", 2, 1, "'Kd' takes 3 numbers, found 4"},
    {"no_number", "newmtl m\nNs # 10\n", 2, 1, "'Ns' takes 1 number, found 0"},
    {"twice", "newmtl m\nKd 0 0 0\nNs 1\nKd 1 1 1\n", 4, 1, "'Kd' was given already, on line 2"},
    {"texture_twice", "newmtl m\nmap_Kd a.png\nmap_Kd b.png\n", 3, 1, "'map_Kd' was given already, on line 2"},
    {"contradiction", "newmtl m\nTr 0.25\nd 0.25\nnewmtl n\n", 3, 3, "d 0.25 and Tr 0.25 contradict each other",
     "Tr is 1 - d; leave one of them away"},
    {"contradiction_the_other_way", "newmtl m\nd 1\nTr 1\n", 3, 4, "d 1 and Tr 1 contradict each other",
     "Tr is 1 - d; leave one of them away"},
    {"no_name", "newmtl m\nnewmtl  \n", 2, 1, "'newmtl' takes a name"},
    {"name_glued", "newmtl m\nnewmtl#n\n", 2, 1, "'newmtl' takes a name"},
    {"defined_twice", "newmtl m\nnewmtl n\n newmtl m\n", 3, 9, "the material 'm' was defined already, on line 1"},
    {"too_early", "Kd 1 1 1\nnewmtl m\n", 1, 1, "'Kd' comes before the first 'newmtl'"},
    {"texture_too_early", "map_Kd a.png\nnewmtl m\n", 1, 1, "'map_Kd' comes before the first 'newmtl'"},
    {"no_texture_name", "newmtl m\nmap_Kd -s 1 1 1\n", 2, 1, "'map_Kd' takes the name of an image file"},
    {"texture_glued", "newmtl m\nmap_Kd#a.png\n", 2, 1, "'map_Kd' takes the name of an image file"},
    {"option_without_numbers", "newmtl m\nmap_Kd -s a.png\n", 2, 8, "the option '-s' takes 1 to 3 numbers, found 0"},
    {"option_with_one_number", "newmtl m\nmap_Kd -mm 1 a.png\n", 2, 8, "the option '-mm' takes 2 numbers, found 1"},
    {"option_at_the_end", "newmtl m\nmap_Kd -clamp\n", 2, 8, "the option '-clamp' takes 1 word, found 0"},
    {"an_obj_file", "v 0 0 0\nv 1 1\nf 1 2 3\n", 1, 1, "'v' is a line of an OBJ file, expected a material library",
     no_library_hint},
    {"a_library_in_a_library", "newmtl m\nmtllib bad.mtl\n", 2, 1,
     "'mtllib' is a line of an OBJ file, expected a material library", no_library_hint},
    {"continued", "newmtl m\nKd 0 \\\n 0 \\\n  x\n", 4, 3, "'x' is not a number"},
};

INSTANTIATE_TEST_SUITE_P(Of, BadMtls, ::testing::ValuesIn(bad_mtls),
                         [](const auto &bad) { return std::string(bad.param.name); });

class BadModels : public ModelFiles {
protected:
    /// The only problem of an OBJ file whose first four lines are four vertices.
    void expect_error(const std::string &obj, ErrorCode code, uint32_t line, uint32_t column,
                      const std::string &message, const std::string &hint = {}, const ReadOptions &options = {}) const {
        const auto model = read_model(write("a/a.obj", std::string(four_vertices) + obj), options);
        ASSERT_FALSE(model.ok()) << obj;
        ASSERT_EQ(model.error().diagnostics.size(), 1u) << model.error().text();
        EXPECT_EQ(model.error().code, code);
        const Diagnostic &diagnostic = model.error().diagnostics[0];
        EXPECT_EQ(diagnostic.line, line) << obj;
        EXPECT_EQ(diagnostic.column, column) << obj;
        EXPECT_EQ(diagnostic.message, message);
        EXPECT_TRUE(diagnostic.hint.starts_with(hint) && (diagnostic.hint.empty() == hint.empty())) << diagnostic.hint;
    }
    [[nodiscard]] std::string real_root() const { return fs::weakly_canonical(in_folder("a")).string(); }
    [[nodiscard]] std::string path(const std::string &name) const { return in_folder("a/" + name).string(); }
};

TEST_F(BadModels, have_the_problems_of_plain_meshes) {
    expect_error("f 1 2 9\n", ErrorCode::bad_input, 5, 7, "vertex 9 does not exist: the file has 4 vertices");
    expect_error("vn 0 0 x\nf 1 2 3\n", ErrorCode::bad_input, 5, 8, "'x' is not a number");
    expect_error("f 1 1 2\n", ErrorCode::bad_input, 0, 0, "none of the mesh's triangles has an area");
    expect_error("", ErrorCode::bad_input, 0, 0, "the file has no face ('f'), so there is nothing to see");
    ReadOptions options;
    options.limits.max_triangles = 1;
    expect_error("f 1 2 3\nf 1 2 3\n", ErrorCode::limit_exceeded, 0, 0, "the mesh has 2 triangles, the limit is 1", {},
                 options);
}

TEST_F(BadModels, have_normals_and_texture_coordinates_that_are_too_far_out) {
    const std::string hint = "coordinates reach from -1e12 to 1e12";
    expect_error("vn 0 0 2e12\nf 1 2 3\n", ErrorCode::bad_input, 5, 8, "'2e12' is too far out", hint);
    expect_error("vt 0 -2e12\nf 1 2 3\n", ErrorCode::bad_input, 5, 6, "'-2e12' is too far out", hint);
}

TEST_F(BadModels, name_materials_that_are_not_there) {
    write("a/a.mtl", "newmtl red\nnewmtl a longer name\n");
    expect_error("usemtl red\nf 1 2 3\n", ErrorCode::bad_input, 5, 8, "there is no material 'red'",
                 "no line 'mtllib' names a library");
    expect_error("mtllib a.mtl\nusemtl rde\nf 1 2 3\n", ErrorCode::bad_input, 6, 8, "there is no material 'rde'",
                 "did you mean 'red'?");
    expect_error("mtllib a.mtl\nusemtl  glass\nf 1 2 3\n", ErrorCode::bad_input, 6, 9, "there is no material 'glass'");
    expect_error("mtllib a.mtl\nusemtl red # as blood\nf 1 2 3\n", ErrorCode::bad_input, 6, 8,
                 "there is no material 'red # as blood'",
                 "a material's name goes to the end of the line, with all that follows a '#'");
    expect_error("mtllib a.mtl\nusemtl\nf 1 2 3\n", ErrorCode::bad_input, 6, 1,
                 "'usemtl' takes the name of a material");
    expect_error("mtllib\nf 1 2 3\n", ErrorCode::bad_input, 5, 1, "'mtllib' takes the name of a material library");
}

TEST_F(BadModels, show_all_materials_that_are_not_there) {
    const auto model = read_model(write("a.obj", std::string(four_vertices) + "usemtl a1\nf 1 2 3\nusemtl b1\nf 1 2 3\n"
                                                                              "usemtl a1\nf 1 2 3\nusemtl c1\n"));
    ASSERT_FALSE(model.ok());
    ASSERT_EQ(model.error().diagnostics.size(), 2u) << model.error().text();
    EXPECT_EQ(model.error().diagnostics[0].message, "there is no material 'a1'");
    EXPECT_EQ(model.error().diagnostics[1].message, "there is no material 'b1'");
    EXPECT_EQ(model.error().diagnostics[1].line, 7u);
}

TEST_F(BadModels, name_libraries_that_cannot_be_read) {
    const std::string rest = "\nusemtl m\nf 1 2 3\n";
    expect_error("mtllib x.mtl" + rest, ErrorCode::not_found, 5, 8, "there is no file 'x.mtl'",
                 "looked for " + path("x.mtl"));
    expect_error("mtllib m\\x.mtl" + rest, ErrorCode::not_found, 5, 8, "there is no file 'm\\x.mtl'",
                 "looked for " + path("m\\x.mtl") + "; folders are separated by '/'");
    write("x.mtl", "newmtl m\n");
    expect_error("mtllib ../x.mtl" + rest, ErrorCode::bad_input, 5, 8,
                 "the path '../x.mtl' leaves the scene root '" + real_root() + "'",
                 "files are named relative to the OBJ file");
    expect_error("mtllib /etc/passwd" + rest, ErrorCode::bad_input, 5, 8,
                 "the path '/etc/passwd' leaves the scene root '" + real_root() + "'",
                 "files are named relative to the OBJ file");
    fs::create_symlink(in_folder("x.mtl"), in_folder("a/link.mtl"));
    expect_error("mtllib link.mtl" + rest, ErrorCode::bad_input, 5, 8,
                 "the path 'link.mtl' leaves the scene root '" + real_root() + "' through a symbolic link");
    write("a/a.mtl", "newmtl m\n");
    expect_error("mtllib a.mtl y.mtl" + rest, ErrorCode::not_found, 5, 14, "there is no file 'y.mtl'",
                 "looked for " + path("y.mtl"));
    fs::create_directories(in_folder("a/folder.mtl"));
    expect_error("mtllib folder.mtl" + rest, ErrorCode::not_found, 5, 8,
                 "material library '" + path("folder.mtl") + "': this is a folder, expected a file");
    ASSERT_EQ(::mkfifo(in_folder("a/pipe.mtl").c_str(), 0600), 0);
    expect_error("mtllib pipe.mtl" + rest, ErrorCode::not_found, 5, 8,
                 "material library '" + path("pipe.mtl") + "': this is a pipe, expected a file");
    ReadOptions options;
    options.max_file_bytes = 100;
    write("a/large.mtl", std::string(101, '\n'));
    expect_error("mtllib large.mtl" + rest, ErrorCode::limit_exceeded, 5, 8,
                 "material library '" + path("large.mtl") + "': the file has 101 bytes, the limit is 100", {}, options);
}

TEST_F(BadModels, may_not_be_their_own_library) {
    expect_error("mtllib a.obj\nusemtl m\nf 1 2 3\n", ErrorCode::bad_input, 1, 1,
                 "'v' is a line of an OBJ file, expected a material library", no_library_hint);
}

TEST_F(BadModels, have_libraries_that_are_no_text) {
    write("a/b.mtl", std::string("newmtl m\nKd 1 \0 1\n", 18));
    expect_error("mtllib b.mtl\nusemtl m\nf 1 2 3\n", ErrorCode::bad_input, 2, 6,
                 "this is not a text file: it has a NUL byte");
}

TEST_F(BadModels, show_problems_of_the_mesh_and_of_its_libraries_in_one_run) {
    write("a.mtl", "newmtl m\nKd 2 0 0\nNs -1\n");
    const auto model = read_model(write("a.obj", "mtllib a.mtl\nmtllib b.mtl\nv 0 0 x\nusemtl other\nf 1 1 1\n"));
    ASSERT_FALSE(model.ok());
    ASSERT_EQ(model.error().diagnostics.size(), 4u) << model.error().text();
    EXPECT_EQ(model.error().diagnostics[0].message, "'x' is not a number");
    EXPECT_EQ(model.error().diagnostics[1].message, "Kd is '2', expected a number from 0 to 1");
    EXPECT_EQ(model.error().diagnostics[2].message, "Ns is '-1', expected a number from 0 to 1e+06");
    EXPECT_EQ(model.error().diagnostics[3].message, "there is no file 'b.mtl'");
}

class BadTextures : public ModelFiles {
protected:
    void expect_error(const std::string &texture, ErrorCode code, const std::string &message, const std::string &hint,
                      const ReadOptions &options) const {
        const fs::path library = write("a/m/a.mtl", "newmtl m\nmap_Kd " + texture + "\n");
        const auto model = read_model(
            write("a/a.obj", std::string(four_vertices) + "mtllib m/a.mtl\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n"),
            options);
        ASSERT_FALSE(model.ok()) << texture;
        ASSERT_EQ(model.error().diagnostics.size(), 1u) << model.error().text();
        EXPECT_EQ(model.error().code, code);
        const Diagnostic &diagnostic = model.error().diagnostics[0];
        EXPECT_EQ(diagnostic.file, library.string());
        EXPECT_EQ(diagnostic.line, 2u);
        EXPECT_EQ(diagnostic.column, 8u);
        EXPECT_EQ(diagnostic.message, message);
        EXPECT_TRUE(diagnostic.hint.starts_with(hint) && (diagnostic.hint.empty() == hint.empty())) << diagnostic.hint;
    }
    [[nodiscard]] std::string real(const std::string &name) const {
        return fs::weakly_canonical(in_folder(name)).string();
    }
};

TEST_F(BadTextures, are_refused_where_the_material_names_them) {
    CountedTextures textures;
    const ReadOptions options = textures.options();
    expect_error("x.png", ErrorCode::not_found, "there is no file 'x.png'",
                 "looked for " + in_folder("a/m/x.png").string() + ", " + real("a/x.png"), options);
    expect_error("maps\\x.png", ErrorCode::not_found, "there is no file 'maps\\x.png'",
                 "looked for " + in_folder("a/m/maps\\x.png").string() + ", " + real("a/maps\\x.png") +
                     "; folders are separated by '/'",
                 options);
    write("x.png", "");
    expect_error("../../x.png", ErrorCode::bad_input,
                 "the path '../../x.png' leaves the scene root '" + real("a") + "'",
                 "files are named relative to the material library", options);
    expect_error("/dev/zero", ErrorCode::bad_input, "the path '/dev/zero' leaves the scene root '" + real("a") + "'",
                 "files are named relative to the material library", options);
    EXPECT_EQ(textures.calls, 0);
}

TEST_F(BadTextures, are_refused_with_the_readers_own_words) {
    ReadOptions options;
    options.read_texture = [](const fs::path &file) -> Result<Texture> {
        return Error(ErrorCode::limit_exceeded, "cannot read '" + file.filename().string() + "'", "a hint");
    };
    write("a/m/x.png", "");
    expect_error("x.png", ErrorCode::limit_exceeded, "cannot read 'x.png'", "a hint", options);
}

} // namespace
} // namespace glint::test
