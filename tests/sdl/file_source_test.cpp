// Scenes whose files come from the program itself: the same rules for paths as in folders, and nothing read elsewhere.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include <glint/glint.hpp>

namespace glint::test {
namespace {

namespace fs = std::filesystem;

const std::string lamp = "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n";
const std::string wall = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

std::string scene_with(const std::string &object) {
    return "dialect mobile2013\neye 0 0 5\nlight lamp.obj 1 1 1 1\nobject " + object + " 1 1 1 .3 .7 0 0 0 1\n";
}

/// An archive that only knows how to read, and notes what it was asked for.
class Archive : public FileSource {
public:
    [[nodiscard]] Result<FileBytes> read(const std::string &path, uint64_t max_bytes) const override {
        asked[path] = std::max(asked[path], max_bytes);
        const auto file = files.find(path);
        if (file == files.end()) return Error(ErrorCode::not_found, "the archive has no such file");
        if (file->second.size() > max_bytes) return Error(ErrorCode::limit_exceeded, "too large");
        if (file->second == "broken") return Error(ErrorCode::io, "the archive is broken here");
        return FileBytes::copy_of(file->second);
    }

    std::map<std::string, std::string> files;
    mutable std::map<std::string, uint64_t> asked; ///< the largest limit, by path
};

class FilesOfTheProgram : public testing::Test {
protected:
    void SetUp() override {
        archive_->files["scenes/lamp.obj"] = lamp;
        archive_->files["wall.obj"] = wall;
        archive_->files["scenes/Input/wall.obj"] = wall;
        options_.files = archive_;
    }
    [[nodiscard]] Result<SceneFile> read(const std::string &object, const std::string &path = "scenes/room.sdl") {
        archive_->files[path] = scene_with(object);
        return read_scene(path, options_);
    }
    void expect_error(const Result<SceneFile> &scene, ErrorCode code, const std::string &message,
                      const std::string &hint) {
        ASSERT_FALSE(scene.ok());
        EXPECT_EQ(scene.error().code, code);
        EXPECT_EQ(scene.error().diagnostics[0].message, message);
        EXPECT_EQ(scene.error().diagnostics[0].hint, hint);
        EXPECT_EQ(scene.error().diagnostics[0].file, "scenes/room.sdl");
        EXPECT_EQ(scene.error().diagnostics[0].line, 4u);
    }

    std::shared_ptr<Archive> archive_ = std::make_shared<Archive>();
    ReadOptions options_;
};

TEST_F(FilesOfTheProgram, are_found_beside_the_scene) {
    const auto scene = read("Input/wall.obj");
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    EXPECT_EQ(scene->mesh_files, (std::vector<fs::path>{"scenes/lamp.obj", "scenes/Input/wall.obj"}));
    EXPECT_EQ(scene->scene->triangle_count(), 3u);
}

TEST_F(FilesOfTheProgram, are_found_further_up_to_the_scene_root) {
    expect_error(read("wall.obj"), ErrorCode::not_found, "there is no file 'wall.obj'", "looked for scenes/wall.obj");
    expect_error(read("../wall.obj"), ErrorCode::bad_input, "the path '../wall.obj' leaves the scene root 'scenes'",
                 "files are named relative to the scene file");
    options_.scene_root = ".";
    EXPECT_TRUE(read("wall.obj").ok());
    EXPECT_TRUE(read("../wall.obj").ok());
    EXPECT_TRUE(read("Input/.././../wall.obj").ok());
    options_.scene_root = "scenes/";
    EXPECT_FALSE(read("wall.obj").ok());
    options_.scene_root = "elsewhere";
    EXPECT_FALSE(read("Input/wall.obj").ok()) << "the scene does not lie there";
}

TEST_F(FilesOfTheProgram, are_never_asked_for_outside_of_the_scene_root) {
    options_.scene_root = ".";
    archive_->files["/wall.obj"] = archive_->files["../wall.obj"] = wall;
    for (const char *name : {"../../wall.obj", "/wall.obj", "Input/../../../wall.obj"}) {
        EXPECT_FALSE(read(name).ok()) << name;
    }
    for (const auto &[path, limit] : archive_->asked) {
        EXPECT_FALSE(path.starts_with("/") || path.starts_with("..")) << path;
    }
    options_.allow_outside_root = true;
    EXPECT_TRUE(read("/wall.obj").ok());
    EXPECT_TRUE(read("../../wall.obj").ok());
}

TEST_F(FilesOfTheProgram, keep_the_beginning_of_the_scenes_path) {
    archive_->files["/app/lamp.obj"] = lamp;
    archive_->files["/app/wall.obj"] = wall;
    const auto scene = read("wall.obj", "/app/./room.sdl");
    EXPECT_FALSE(scene.ok()) << "the archive knows no dots in paths, and the test wrote one";
    archive_->files["/app/room.sdl"] = scene_with("wall.obj");
    EXPECT_TRUE(read_scene("/app/./room.sdl", options_).ok());
    EXPECT_FALSE(read("../wall.obj", "/app/room.sdl").ok());
    for (const auto &[path, limit] : archive_->asked) EXPECT_TRUE(path.starts_with("/app/")) << path;
}

TEST_F(FilesOfTheProgram, are_never_taken_from_the_system) {
    const auto folder = fs::path(GLINT_SOURCE_DIR) / "scenes" / "sdl";
    options_.allow_outside_root = true;
    EXPECT_EQ(read_scene(folder / "cornell.sdl", options_).error().code, ErrorCode::not_found);
    EXPECT_FALSE(read((folder / "floor.obj").string()).ok());
    EXPECT_FALSE(read_obj(folder / "floor.obj", options_).ok());
    EXPECT_FALSE(read_model(folder / "floor.obj", options_).ok());
}

TEST_F(FilesOfTheProgram, that_cannot_be_read_are_told_of_where_they_are_named) {
    archive_->files["scenes/wall.obj"] = "broken";
    expect_error(read("wall.obj"), ErrorCode::io, "mesh 'scenes/wall.obj': the archive is broken here", "");
    archive_->files["scenes/room.sdl"] = "broken";
    const auto scene = read_scene("scenes/room.sdl", options_);
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().text(), "scenes/room.sdl: error: the archive is broken here");
}

TEST_F(FilesOfTheProgram, keep_to_the_limit) {
    options_.max_file_bytes = 200;
    ASSERT_TRUE(read("Input/wall.obj").ok());
    for (const auto &[path, limit] : archive_->asked) EXPECT_LE(limit, 200u) << path;
    archive_->files["scenes/Input/wall.obj"] = wall + std::string(200, '#');
    EXPECT_EQ(read("Input/wall.obj").error().code, ErrorCode::limit_exceeded);
}

TEST_F(FilesOfTheProgram, bring_materials_and_textures) {
    archive_->files["scenes/m/house.obj"] =
        "mtllib house.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl red\nf 1/1 2/2 3/3\n";
    archive_->files["scenes/m/house.mtl"] = "newmtl red\nKd 1 0 0\nmap_Kd ../t/x.png\n";
    archive_->files["scenes/t/x.png"] = "pixels";
    const std::string text = "eye 0 0 5\nreflections 3\nlight lamp.obj 1 1 1 1\nobject m/house.obj mtl\n";
    archive_->files["scenes/house.sdl"] = text;
    const auto without = read_scene("scenes/house.sdl", options_);
    ASSERT_TRUE(without.ok()) << without.error().text();
    EXPECT_EQ(without->warnings.size(), 1u) << "no textures are read";

    std::string decoded;
    options_.decode_texture = [&](std::string_view bytes, const std::string &path) -> Result<Texture> {
        decoded += path + "=" + std::string(bytes) + ";";
        return Texture{1, 1, {Color(0.5f)}};
    };
    const auto with = read_scene("scenes/house.sdl", options_);
    ASSERT_TRUE(with.ok()) << with.error().text();
    EXPECT_TRUE(with->warnings.empty());
    EXPECT_NE(with->scene->objects()[0].material.texture, nullptr);
    EXPECT_EQ(decoded, "scenes/t/x.png=pixels;");
    const auto model = read_model("scenes/m/house.obj", options_);
    EXPECT_FALSE(model.ok()) << "the texture lies outside of the model's own folder";

    options_.decode_texture = [](std::string_view, const std::string &) -> Result<Texture> {
        return Error(ErrorCode::bad_input, "no picture");
    };
    const auto refused = read_scene("scenes/house.sdl", options_);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().diagnostics[0].message, "texture 'scenes/m/../t/x.png': no picture");
    EXPECT_EQ(refused.error().diagnostics[0].file, "scenes/m/house.mtl");
}

TEST_F(FilesOfTheProgram, are_converted) {
    ASSERT_TRUE(read("Input/wall.obj").ok());
    const auto converted = convert_scene("scenes/room.sdl", "new", options_);
    ASSERT_TRUE(converted.ok()) << converted.error().text();
    EXPECT_NE(converted->text.find("../scenes/Input/wall.obj"), std::string::npos) << converted->text;
    EXPECT_EQ(converted->scene_root, fs::path(""));
}

TEST(MemoryFiles, hold_a_whole_scene) {
    auto files = std::make_shared<MemoryFiles>();
    ReadOptions options;
    options.files = files;
    for (const auto &entry : fs::directory_iterator(GLINT_SOURCE_DIR "/scenes/sdl")) {
        if (!entry.is_regular_file()) continue;
        std::ostringstream text;
        text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        files->add("./scenes/x/../" + entry.path().filename().string(), text.str());
    }
    const auto from_memory = read_scene("scenes/cornell.sdl", options);
    ASSERT_TRUE(from_memory.ok()) << from_memory.error().text();
    const auto from_system = read_scene(GLINT_SOURCE_DIR "/scenes/sdl/cornell.sdl");
    auto a = Framebuffer::create(64, 64), b = Framebuffer::create(64, 64);
    ASSERT_TRUE(Renderer(Accel::build(from_memory->scene)).render(*a));
    ASSERT_TRUE(Renderer(Accel::build(from_system->scene)).render(*b));
    EXPECT_EQ(a->radiance_hash(), b->radiance_hash());
}

TEST(MemoryFiles, answer_by_path) {
    MemoryFiles files;
    files.add("a/b.obj", "old").add("a/./b.obj", "new").add("empty", "");
    EXPECT_EQ(files.read("a/b.obj", 3)->view(), "new");
    EXPECT_EQ(files.read("a/c/../b.obj", 3)->view(), "new");
    EXPECT_EQ(files.read("a/b.obj", 2).error().code, ErrorCode::limit_exceeded);
    EXPECT_EQ(files.read("a", 100).error().code, ErrorCode::not_found);
    EXPECT_EQ(files.read("empty", 0)->size, 0u);
    EXPECT_TRUE(files.contains("a/b.obj"));
    EXPECT_FALSE(files.contains("a"));
}

TEST(SceneText, is_read_as_if_it_lay_in_a_file) {
    const std::string text = scene_with("floor.obj");
    const fs::path place = GLINT_SOURCE_DIR "/scenes/sdl/in_memory.sdl";
    std::string with_lamp = text;
    with_lamp.replace(with_lamp.find("lamp.obj"), 8, "luzcornell.obj");
    const auto scene = read_scene_text(with_lamp, place);
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    EXPECT_EQ(scene->mesh_files.size(), 2u);
    const auto refused = read_scene_text(text, place);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().diagnostics[0].file, place.string());
}

} // namespace
} // namespace glint::test
