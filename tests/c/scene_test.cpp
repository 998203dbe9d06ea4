// Scenes from files, memory and the host's own file source; what is in them; moving them.
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>

#include "c/c_handles.hpp"

namespace glint::test {
namespace {

Made<glint_scene> read_file(const std::string &file, const glint_read_options *options = nullptr) {
    return make<glint_scene>([&](glint_scene **place) { return glint_scene_read(file.c_str(), options, place); });
}

glint_scene_info info_of(const Made<glint_scene> &scene) {
    auto info = to_fill<glint_scene_info>();
    EXPECT_EQ(glint_scene_get_info(scene.get(), &info), GLINT_OK) << scene.message();
    return info;
}

TEST(CScene, is_read_from_a_file) {
    const auto cornell = read_file(GLINT_SOURCE_DIR "/scenes/sdl/cornell.sdl");
    const glint_scene_info info = info_of(cornell);
    EXPECT_STREQ(info.dialect, "mobile2013");
    EXPECT_GT(std::strlen(info.dialect_reason), 0u);
    EXPECT_EQ(info.objects, 7u);
    EXPECT_EQ(info.lights, 1u);
    EXPECT_EQ(info.triangles, 32u);
    EXPECT_EQ(info.width_px, 256u);
    EXPECT_EQ(info.height_px, 256u);
    EXPECT_EQ(info.max_depth, 1u);
    EXPECT_EQ(info.is_animated, 0);
    float lower[3], upper[3];
    ASSERT_EQ(glint_scene_get_bounds(cornell.get(), lower, upper), GLINT_OK);
    for (int i = 0; i < 3; ++i) EXPECT_LT(lower[i], upper[i]);
    glint_camera camera;
    ASSERT_EQ(glint_scene_get_camera(cornell.get(), &camera), GLINT_OK);
    EXPECT_EQ(camera.eye[2], 5.7f);
}

TEST(CScene, is_read_from_memory) {
    const auto room = read_room();
    const glint_scene_info info = info_of(room);
    EXPECT_EQ(info.triangles, 3u);
    EXPECT_EQ(info.width_px, 48u);
    EXPECT_EQ(info.max_depth, 2u);
    auto object = to_fill<glint_object_info>();
    ASSERT_EQ(glint_scene_get_object(room.get(), 0, &object), GLINT_OK);
    EXPECT_STREQ(object.name, "floor.obj");
    EXPECT_EQ(object.triangles, 2u);
    EXPECT_EQ(object.can_move, 0);
    EXPECT_EQ(glint_scene_get_object(room.get(), 1, &object), GLINT_ERROR_INVALID_ARGUMENT);
}

/// An app's assets.
struct Assets {
    std::map<std::string, std::string> files;
    glint_error broken = GLINT_OK; ///< what reading returns instead
    int reads = 0;

    static glint_error read(void *user, const char *path, uint64_t max_bytes, glint_file *file) {
        auto &assets = *static_cast<Assets *>(user);
        ++assets.reads;
        if (assets.broken != GLINT_OK) return assets.broken;
        const auto found = assets.files.find(path);
        if (found == assets.files.end()) return GLINT_ERROR_NOT_FOUND;
        const std::string &bytes = found->second;
        if (bytes.size() > max_bytes) return GLINT_ERROR_LIMIT_EXCEEDED;
        void *const memory = glint_file_allocate(file, bytes.size());
        if (!memory) return GLINT_ERROR_OUT_OF_MEMORY;
        std::memcpy(memory, bytes.data(), bytes.size());
        return GLINT_OK;
    }
};

class CFileSource : public testing::Test {
protected:
    Made<glint_scene> read() {
        const glint_file_source source{sizeof source, &assets, Assets::read, nullptr};
        options.files = &source;
        return read_file("scenes/room.sdl", &options);
    }

    Assets assets{{{"scenes/room.sdl", room_text}, {"scenes/floor.obj", floor_text}, {"scenes/lamp.obj", lamp_text}}};
    glint_read_options options = with_defaults(glint_read_options_init);
};

TEST_F(CFileSource, brings_every_file) {
    EXPECT_EQ(info_of(read()).triangles, 3u);
    EXPECT_GE(assets.reads, 3);
}

TEST_F(CFileSource, says_what_is_missing) {
    assets.files.erase("scenes/lamp.obj");
    const auto scene = read();
    EXPECT_EQ(scene.code, GLINT_ERROR_NOT_FOUND) << scene.message();
    EXPECT_NE(scene.message().find("lamp.obj"), std::string::npos) << scene.message();
}

TEST_F(CFileSource, fails_as_its_callback_does) {
    for (const glint_error code :
         {GLINT_ERROR_IO, GLINT_ERROR_NOT_FOUND, GLINT_ERROR_LIMIT_EXCEEDED, GLINT_ERROR_OUT_OF_MEMORY}) {
        assets.broken = code;
        EXPECT_EQ(read().code, code);
    }
    for (const glint_error code : {-5, 99, GLINT_ERROR_CANCELLED + 0}) {
        assets.broken = code;
        EXPECT_EQ(read().code, GLINT_ERROR_IO);
    }
}

TEST_F(CFileSource, gives_no_more_than_the_options_allow) {
    options.max_file_bytes = 20;
    EXPECT_EQ(read().code, GLINT_ERROR_LIMIT_EXCEEDED);
}

TEST(CScene, tells_every_problem_of_a_file_in_parts) {
    const char text[] = "eye 0 0,5 5.7\nsize 48\n";
    const auto scene = make<glint_scene>(
        [&](glint_scene **place) { return glint_scene_read_text(text, sizeof text - 1, "room.sdl", nullptr, place); });
    EXPECT_EQ(scene.code, GLINT_ERROR_BAD_INPUT);
    auto diagnostic = to_fill<glint_diagnostic>();
    ASSERT_EQ(glint_scene_get_diagnostic(scene.get(), 0, &diagnostic), GLINT_OK);
    EXPECT_STREQ(diagnostic.file, "room.sdl");
    EXPECT_EQ(diagnostic.line, 1u);
    EXPECT_EQ(diagnostic.column, 7u);
    EXPECT_EQ(diagnostic.is_error, 1);
    EXPECT_NE(std::string(diagnostic.message).find("'0,5' is not a number"), std::string::npos);
    EXPECT_STREQ(diagnostic.source_line, "eye 0 0,5 5.7");
    EXPECT_NE(scene.message().find(diagnostic.message), std::string::npos);
    EXPECT_EQ(glint_scene_get_diagnostic(scene.get(), 1, &diagnostic), GLINT_OK);
    EXPECT_EQ(glint_scene_get_diagnostic(scene.get(), 1000, &diagnostic), GLINT_ERROR_INVALID_ARGUMENT);
}

TEST(CScene, an_object_is_moved_into_another_scene) {
    const auto carousel = read_file(GLINT_SOURCE_DIR "/scenes/sdl/carousel.sdl");
    const glint_scene_info info = info_of(carousel);
    EXPECT_EQ(info.is_animated, 1);
    uint32_t mover = 0;
    auto object = to_fill<glint_object_info>();
    while (glint_scene_get_object(carousel.get(), mover, &object) == GLINT_OK && !object.can_move) ++mover;
    ASSERT_LT(mover, info.objects);

    glint_object_pose there{mover, {}};
    const float axis[3] = {0.0f, 3.0f, 0.0f}, by[3] = {1.0f, 2.0f, 3.0f};
    ASSERT_EQ(glint_pose_turned(axis, std::numbers::pi / 2, nullptr, by, &there.pose), GLINT_OK);
    EXPECT_NEAR(there.pose.x[2], -1.0f, 1e-6f);
    const auto moved =
        make<glint_scene>([&](glint_scene **place) { return glint_scene_move(carousel.get(), &there, 1, place); });
    ASSERT_EQ(moved.code, GLINT_OK) << moved.message();
    ASSERT_EQ(glint_scene_get_object(moved.get(), mover, &object), GLINT_OK);
    EXPECT_EQ(object.pose.translation[1], 2.0f);

    const auto later = make<glint_scene>([&](glint_scene **place) { return glint_scene_at(moved.get(), 0.5, place); });
    EXPECT_EQ(later.code, GLINT_OK) << later.message();
    there.object = 1u << 30;
    const auto refused =
        make<glint_scene>([&](glint_scene **place) { return glint_scene_move(carousel.get(), &there, 1, place); });
    EXPECT_EQ(refused.code, GLINT_ERROR_BAD_INPUT);
    EXPECT_GT(refused.message().size(), 0u);
}

TEST(CScene, cameras_and_poses_that_lead_nowhere_are_refused) {
    const float eye[3] = {0, 0, 5}, target[3] = {0, 0, 0}, up[3] = {0, 1, 0}, along[3] = {0, 0, 2}, zero[3] = {};
    const float wild[3] = {NAN, 0, 0};
    glint_camera camera = {};
    EXPECT_EQ(glint_camera_look_at(eye, target, up, 2, 2, &camera), GLINT_OK);
    EXPECT_NEAR(camera.top_left[0], -1.0f, 1e-6f);
    EXPECT_NEAR(camera.top_left[2], 4.0f, 1e-6f);
    const glint_camera before = camera;
    EXPECT_EQ(glint_camera_look_at(eye, eye, up, 2, 2, &camera), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_camera_look_at(eye, target, along, 2, 2, &camera), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_camera_look_at(wild, target, up, 2, 2, &camera), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_camera_look_at(eye, target, up, INFINITY, 2, &camera), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(std::memcmp(&camera, &before, sizeof camera), 0);
    glint_pose pose;
    EXPECT_EQ(glint_pose_turned(zero, 1.0, nullptr, nullptr, &pose), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_pose_turned(up, NAN, nullptr, nullptr, &pose), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_pose_turned(up, 1.0, wild, nullptr, &pose), GLINT_ERROR_INVALID_ARGUMENT);
}

} // namespace
} // namespace glint::test
