// Objects that bring their materials with them.
#include <string>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/written_files.hpp"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

class ScenesWithMtl : public WrittenFiles {
protected:
    void SetUp() override {
        WrittenFiles::SetUp();
        write("lamp.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
        write("m/house.obj", "mtllib house.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
                             "f 1 2 3\nusemtl red\nf 1/1/1 2/2/1 3/3/1 4\nusemtl roof\nf 1/1 2/2 4/3\n");
        write("m/house.mtl", "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 20\nmap_Kd ../t/x.png\n"
                             "newmtl roof\nmap_Kd x.png\nTr 0.5\nNi 1.5\n");
        write("t/x.png", "");
        fs::create_symlink("../t/x.png", in_folder("m/x.png"));
        options_.read_texture = [this](const fs::path &) -> Result<Texture> {
            ++textures_read_;
            return Texture{1, 1, {Color(0.5f)}};
        };
    }
    [[nodiscard]] Result<SceneFile> read(const std::string &objects) {
        return read_scene(write("scene.sdl", "eye 0 0 5\nreflections 3\nlight lamp.obj 1 1 1 1\n" + objects), options_);
    }
    [[nodiscard]] SceneFile read_good(const std::string &objects) {
        auto scene = read(objects);
        if (!scene.ok()) throw std::runtime_error(scene.error().text());
        return std::move(scene).value();
    }
    /// The only problem of a scene whose fourth line is this.
    void expect_error(const std::string &object, ErrorCode code, const fs::path &file, uint32_t line, uint32_t column,
                      const std::string &message, const std::string &hint = {}) {
        const auto scene = read(object);
        ASSERT_FALSE(scene.ok()) << object;
        ASSERT_EQ(scene.error().diagnostics.size(), 1u) << scene.error().text();
        EXPECT_EQ(scene.error().code, code);
        const Diagnostic &diagnostic = scene.error().diagnostics[0];
        EXPECT_EQ(diagnostic.file, file.string());
        EXPECT_EQ(diagnostic.line, line);
        EXPECT_EQ(diagnostic.column, column);
        EXPECT_EQ(diagnostic.message, message);
        EXPECT_EQ(diagnostic.hint, hint);
    }

    ReadOptions options_;
    int textures_read_ = 0;
};

TEST_F(ScenesWithMtl, have_an_object_for_each_material) {
    const SceneFile file = read_good("object m/house.obj mtl\n");
    const auto &objects = file.scene->objects();
    ASSERT_EQ(objects.size(), 3u);
    EXPECT_EQ(objects[0].name, "m/house.obj");
    EXPECT_EQ(objects[0].material.color, Color(1.0f));
    EXPECT_EQ(objects[1].name, "m/house.obj:red");
    EXPECT_EQ(objects[1].material.color, Color(1, 0, 0));
    EXPECT_EQ(objects[1].material.specular, 0.5f);
    EXPECT_EQ(objects[1].mesh->triangles.size(), 2u);
    EXPECT_EQ(objects[1].mesh->normals.size(), 1u);
    EXPECT_EQ(objects[2].name, "m/house.obj:roof");
    EXPECT_EQ(objects[2].material.transmission, 0.5f);
    EXPECT_EQ(objects[2].material.ior, 1.5f);
    ASSERT_NE(objects[1].material.texture, nullptr);
    EXPECT_EQ(objects[1].material.texture, objects[2].material.texture);
    EXPECT_EQ(textures_read_, 1);
    EXPECT_EQ(file.mesh_files, (std::vector<fs::path>{in_folder("lamp.obj"), in_folder("m/house.obj")}));
    EXPECT_TRUE(file.warnings.empty());
}

TEST_F(ScenesWithMtl, read_a_model_once_however_they_name_it) {
    const SceneFile file = read_good("object m/house.obj mtl\nobject ./m/house.obj mtl\nobject m/house.obj mtl\n"
                                     "dialect mobile2013\nobject m/house.obj 1 1 1 0 1 0 0 0 0\n");
    const auto &objects = file.scene->objects();
    ASSERT_EQ(objects.size(), 10u);
    EXPECT_EQ(objects[3].mesh, objects[0].mesh);
    EXPECT_EQ(objects[7].mesh, objects[1].mesh);
    EXPECT_EQ(objects[9].mesh->triangles.size(), 4u) << "the plain mesh";
    EXPECT_TRUE(objects[9].mesh->normals.empty());
    EXPECT_EQ(textures_read_, 1);
    EXPECT_EQ(file.mesh_files.size(), 2u);
}

TEST_F(ScenesWithMtl, may_be_of_any_dialect) {
    for (const std::string dialect : {"mobile2013", "path2005", "ray2005", "cg-path-tracer", "raycife", "glint"}) {
        const SceneFile file = read_good("dialect " + dialect + "\nobject m/house.obj mtl\n");
        EXPECT_EQ(file.dialect, dialect);
        for (const Object &object : file.scene->objects()) EXPECT_FALSE(object.material.adds_to_local) << dialect;
    }
}

TEST_F(ScenesWithMtl, leave_normals_aside_where_the_caller_wants_it) {
    options_.flat = true;
    const SceneFile file = read_good("object m/house.obj mtl\n");
    for (const Object &object : file.scene->objects()) {
        EXPECT_TRUE(object.mesh->normals.empty()) << object.name;
    }
}

TEST_F(ScenesWithMtl, count_their_triangles) {
    options_.limits.max_triangles = 5;
    EXPECT_TRUE(read("object m/house.obj mtl\n").ok());
    expect_error("object m/house.obj mtl\nobject m/house.obj mtl\n", ErrorCode::limit_exceeded, in_folder("scene.sdl"),
                 5, 8, "with this mesh the scene has 9 triangles, the limit is 5");
}

TEST_F(ScenesWithMtl, tell_of_problems_where_they_are) {
    expect_error("object x.obj mtl\nobject x.obj mtl\n", ErrorCode::not_found, in_folder("scene.sdl"), 4, 8,
                 "there is no file 'x.obj'", "looked for " + in_folder("x.obj").string());
    const fs::path empty = write("empty.obj", "# nothing\n");
    expect_error("object empty.obj mtl\n", ErrorCode::bad_input, empty, 0, 0,
                 "the file has no face ('f'), so there is nothing to see",
                 "named in " + in_folder("scene.sdl").string() + ":4:8");
    const fs::path house = write("house.obj", "mtllib m/house.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl rde\nf 1 2 3\n");
    expect_error("object house.obj mtl\n", ErrorCode::bad_input, house, 5, 8, "there is no material 'rde'",
                 "did you mean 'red'?");
    const fs::path library = write("m/house.mtl", "newmtl red\nKd 2 0 0\n");
    expect_error("object m/house.obj mtl\n", ErrorCode::bad_input, library, 2, 4,
                 "Kd is '2', expected a number from 0 to 1");
    write("m/house.mtl", "newmtl red\nmap_Kd ../../outside_of_the_scene.png\nnewmtl roof\n");
    expect_error("object m/house.obj mtl\n", ErrorCode::bad_input, library, 2, 8,
                 "the path '../../outside_of_the_scene.png' leaves the scene root '" + fs::canonical(in_folder("")).string() + "'",
                 "files are named relative to the material library");
}

} // namespace
} // namespace glint::test
