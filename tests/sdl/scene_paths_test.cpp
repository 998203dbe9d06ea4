// Where a scene's files are found, and which are out of bounds.
#include <string>

#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <glint/read.hpp>

#include "support/written_files.hpp"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view wall = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class ScenePaths : public WrittenFiles {
protected:
    /// A scene in `folder` whose object is `mesh`; its lamp lies beside it.
    [[nodiscard]] Result<SceneFile> read(const std::string &folder, const std::string &mesh,
                                         const ReadOptions &options = {}, const std::string &more = {}) const {
        write(folder + "/lamp.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
        return read_scene(write(folder + "/scene.sdl", "eye 0 0 5\nmax_depth 1\nlight lamp.obj 1 1 1 1\nobject " +
                                                           mesh + " 1 1 1 0 1 0 0 0 0\n" + more),
                          options);
    }
    void expect_found(const Result<SceneFile> &scene, const fs::path &mesh) const {
        ASSERT_TRUE(scene.ok()) << scene.error().text();
        EXPECT_EQ(fs::canonical(scene->mesh_files.at(1)), fs::canonical(mesh));
    }
    void expect_error(const Result<SceneFile> &scene, ErrorCode code, const std::string &message,
                      const std::string &hint = {}) const {
        ASSERT_FALSE(scene.ok());
        ASSERT_EQ(scene.error().diagnostics.size(), 1u) << scene.error().text();
        EXPECT_EQ(scene.error().code, code);
        const Diagnostic &diagnostic = scene.error().diagnostics[0];
        EXPECT_EQ(diagnostic.line, 4u);
        EXPECT_EQ(diagnostic.column, 8u);
        EXPECT_EQ(diagnostic.message, message);
        EXPECT_EQ(diagnostic.hint, hint);
    }
    [[nodiscard]] ReadOptions rooted_in(const std::string &folder) const {
        ReadOptions options;
        options.scene_root = in_folder(folder);
        return options;
    }
    [[nodiscard]] std::string real(const std::string &name) const {
        return fs::weakly_canonical(in_folder(name)).string();
    }
};

TEST_F(ScenePaths, start_at_the_scene_file) {
    write("a/meshes/wall.obj", wall);
    expect_found(read("a", "meshes/wall.obj"), in_folder("a/meshes/wall.obj"));
    expect_found(read("a", "./meshes/../meshes/wall.obj"), in_folder("a/meshes/wall.obj"));
}

TEST_F(ScenePaths, go_up_to_the_scene_root) {
    write("Input/wall.obj", wall);
    expect_found(read("Input/config", "Input/wall.obj", rooted_in("")), in_folder("Input/wall.obj"));
    expect_found(read("Input/config", "wall.obj", rooted_in("Input")), in_folder("Input/wall.obj"));
    expect_found(read("Input/config", "../wall.obj", rooted_in("Input")), in_folder("Input/wall.obj"));
    write("Input/config/wall.obj", wall);
    expect_found(read("Input/config", "wall.obj", rooted_in("")), in_folder("Input/config/wall.obj"));
}

TEST_F(ScenePaths, work_from_the_current_folder) {
    write("wall.obj", wall);
    ASSERT_TRUE(read(".", "wall.obj").ok());
    const fs::path before = fs::current_path();
    fs::current_path(in_folder(""));
    const auto scene = read_scene("scene.sdl");
    fs::current_path(before);
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    EXPECT_EQ(scene->mesh_files.at(1), "wall.obj");
}

TEST_F(ScenePaths, that_lead_nowhere_tell_every_place_that_was_tried) {
    expect_error(read("a/b", "x.obj", rooted_in("")), ErrorCode::not_found, "there is no file 'x.obj'",
                 "looked for " + in_folder("a/b/x.obj").string() + ", " + real("a/x.obj") + ", " + real("x.obj"));
    expect_error(read("a", "m\\x.obj"), ErrorCode::not_found, "there is no file 'm\\x.obj'",
                 "looked for " + in_folder("a/m\\x.obj").string() + "; folders are separated by '/'");
    expect_error(read("a", "lamp.obj/x"), ErrorCode::not_found, "there is no file 'lamp.obj/x'",
                 "looked for " + in_folder("a/lamp.obj/x").string());
}

TEST_F(ScenePaths, that_a_folder_above_the_root_has_tell_of_it) {
    write("Input/wall.obj", wall);
    const auto looked_for = [&](const std::string &mesh) {
        return "looked for " + in_folder("Input/config/" + mesh).string();
    };
    const auto expect_hint = [&](const std::string &mesh, const std::string &root) {
        const auto scene = read("Input/config", mesh);
        expect_error(scene, ErrorCode::not_found, "there is no file '" + mesh + "'",
                     looked_for(mesh) + "; --scene-root " + real(root) + " would find " + real("Input/wall.obj"));
        expect_found(read("Input/config", mesh, rooted_in(root)), in_folder("Input/wall.obj"));
    };
    expect_hint("wall.obj", "Input");
    expect_hint("Input/wall.obj", "");
    fs::create_symlink("Input/wall.obj", in_folder("link.obj"));
    const auto scene = read("Input/config", "link.obj");
    expect_error(scene, ErrorCode::not_found, "there is no file 'link.obj'",
                 looked_for("link.obj") + "; --scene-root " + real("") + " would find " + real("") + "/link.obj");
    fs::create_directories(in_folder("Input/folder.obj"));
    expect_error(read("Input/config", "folder.obj"), ErrorCode::not_found, "there is no file 'folder.obj'",
                 looked_for("folder.obj"));
}

TEST_F(ScenePaths, that_leave_the_root_are_refused) {
    write("wall.obj", wall);
    const auto outside = [&](const std::string &name) {
        return "the path '" + name + "' leaves the scene root '" + real("a") + "'";
    };
    const std::string hint = "files are named relative to the scene file";
    const std::string wider = "; --scene-root " + real("") + " would find " + real("wall.obj");
    fs::create_directories(in_folder("a/b"));
    expect_error(read("a", "../wall.obj"), ErrorCode::bad_input, outside("../wall.obj"), hint + wider);
    expect_error(read("a", "b/../../wall.obj"), ErrorCode::bad_input, outside("b/../../wall.obj"), hint + wider);
    expect_error(read("a", "/etc/passwd"), ErrorCode::bad_input, outside("/etc/passwd"), hint);
    expect_error(read("a", "../missing.obj"), ErrorCode::bad_input, outside("../missing.obj"), hint);
}

TEST_F(ScenePaths, that_leave_the_root_through_a_link_are_refused) {
    write("outside/wall.obj", wall);
    fs::create_directory(in_folder("a"));
    fs::create_symlink(in_folder("outside/wall.obj"), in_folder("a/link.obj"));
    fs::create_symlink(in_folder("outside"), in_folder("a/folder"));
    for (const std::string name : {"link.obj", "folder/wall.obj"}) {
        expect_error(read("a", name), ErrorCode::bad_input,
                     "the path '" + name + "' leaves the scene root '" + real("a") + "' through a symbolic link");
    }
    fs::create_symlink("inside.obj", in_folder("a/fine.obj"));
    write("a/inside.obj", wall);
    expect_found(read("a", "fine.obj"), in_folder("a/inside.obj"));
}

TEST_F(ScenePaths, may_leave_the_root_where_the_caller_allows_it) {
    write("wall.obj", wall);
    ReadOptions options;
    options.allow_outside_root = true;
    expect_found(read("a", "../wall.obj", options), in_folder("wall.obj"));
    expect_found(read("a", in_folder("wall.obj").string(), options), in_folder("wall.obj"));
    options.scene_root = in_folder("elsewhere");
    fs::create_directory(in_folder("elsewhere"));
    expect_found(read("a", "../wall.obj", options), in_folder("wall.obj"));
    expect_error(read("a", "/missing.obj", options), ErrorCode::not_found, "there is no file '/missing.obj'",
                 "looked for /missing.obj");
}

TEST_F(ScenePaths, need_a_root_that_holds_the_scene) {
    fs::create_directory(in_folder("elsewhere"));
    const auto scene = read("a", "wall.obj", rooted_in("elsewhere"));
    ASSERT_FALSE(scene.ok());
    EXPECT_EQ(scene.error().text(), in_folder("a/scene.sdl").string() +
                                        ": error: the scene file is not inside the scene root '" +
                                        in_folder("elsewhere").string() + "'");
    const auto missing = read("a", "wall.obj", rooted_in("missing"));
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().diagnostics.at(0).message,
              "the scene root '" + in_folder("missing").string() + "' is not a folder");
}

TEST_F(ScenePaths, to_what_is_no_file_are_refused_without_opening_it) {
    const auto mesh = [&](const std::string &name, const std::string &message) {
        return "mesh '" + in_folder("a/" + name).string() + "': " + message;
    };
    fs::create_directories(in_folder("a/folder.obj"));
    expect_error(read("a", "folder.obj"), ErrorCode::not_found,
                 mesh("folder.obj", "this is a folder, expected a file"));
    ASSERT_EQ(::mkfifo(in_folder("a/pipe.obj").c_str(), 0600), 0);
    expect_error(read("a", "pipe.obj"), ErrorCode::not_found, mesh("pipe.obj", "this is a pipe, expected a file"));
    ReadOptions options;
    options.allow_outside_root = true;
    expect_error(read("a", "/dev/zero", options), ErrorCode::not_found,
                 "mesh '/dev/zero': this is a device, expected a file");
    if (::geteuid() != 0) {
        fs::permissions(write("a/secret.obj", wall), fs::perms::none);
        expect_error(read("a", "secret.obj"), ErrorCode::not_found,
                     mesh("secret.obj", "the file may not be read: permission denied"));
    }
    options = {};
    options.max_file_bytes = 200;
    write("a/large.obj", std::string(201, '\n'));
    expect_error(read("a", "large.obj", options), ErrorCode::limit_exceeded,
                 mesh("large.obj", "the file has 201 bytes, the limit is 200"));
}

TEST_F(ScenePaths, of_the_scene_itself_are_checked_too) {
    const auto expect = [](const fs::path &path, const std::string &message) {
        const auto scene = read_scene(path);
        ASSERT_FALSE(scene.ok());
        EXPECT_EQ(scene.error().code, ErrorCode::not_found);
        EXPECT_EQ(scene.error().text(), path.string() + ": error: " + message);
    };
    expect(in_folder("missing.sdl"), "there is no such file");
    expect(in_folder(""), "this is a folder, expected a file");
    expect("/dev/zero", "this is a device, expected a file");
    ASSERT_EQ(::mkfifo(in_folder("pipe.sdl").c_str(), 0600), 0);
    expect(in_folder("pipe.sdl"), "this is a pipe, expected a file");
}

TEST_F(ScenePaths, of_the_output_stay_inside_as_well) {
    write("a/wall.obj", wall);
    const auto good = read("a", "wall.obj", {}, "output pictures/../room.png\n");
    ASSERT_TRUE(good.ok()) << good.error().text();
    EXPECT_EQ(good->output_file, "pictures/../room.png");
    for (const std::string name : {"../room.png", "/tmp/room.png", "x/../../room.png"}) {
        const auto bad = read("a", "wall.obj", {}, "output " + name + "\n");
        ASSERT_FALSE(bad.ok()) << name;
        EXPECT_EQ(bad.error().diagnostics.at(0).line, 5u);
        EXPECT_EQ(bad.error().diagnostics.at(0).message,
                  "the path '" + name + "' leaves the scene root '" + real("a") + "'");
    }
    ReadOptions options;
    options.allow_outside_root = true;
    EXPECT_TRUE(read("a", "wall.obj", options, "output ../room.png\n").ok());
}

} // namespace
} // namespace glint::test
