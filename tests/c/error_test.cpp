// Codes, messages, NULL, handles of another kind, structs that grow.
#include <array>
#include <cstring>
#include <vector>

#include "c/c_handles.hpp"

namespace glint::test {
namespace {

TEST(CErrors, every_code_has_a_name) {
    EXPECT_STREQ(glint_error_name(GLINT_OK), "OK");
    EXPECT_STREQ(glint_error_name(GLINT_ERROR_CANCELLED), "CANCELLED");
    EXPECT_STREQ(glint_error_name(GLINT_ERROR_INTERNAL), "INTERNAL");
    for (const glint_error code : {-1, 10, INT32_MAX, INT32_MIN}) EXPECT_STREQ(glint_error_name(code), "UNKNOWN");
}

TEST(CErrors, the_version_is_that_of_the_headers) {
    auto version = to_fill<glint_version>();
    ASSERT_EQ(glint_get_version(&version), GLINT_OK);
    EXPECT_EQ(version.major, GLINT_VERSION_MAJOR);
    EXPECT_EQ(version.minor, GLINT_VERSION_MINOR);
    EXPECT_EQ(version.patch, GLINT_VERSION_PATCH);
    EXPECT_EQ(version.text, std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
                                std::to_string(version.patch));
    EXPECT_GT(std::strlen(version.compiler), 0u);
    EXPECT_GT(std::strlen(version.isa), 0u);
    EXPECT_EQ(glint_get_version(nullptr), GLINT_ERROR_INVALID_ARGUMENT);
}

TEST(CErrors, a_creating_function_that_fails_leaves_a_handle_that_says_why) {
    const auto scene =
        make<glint_scene>([](glint_scene **place) { return glint_scene_read("there/is/no/such.sdl", nullptr, place); });
    EXPECT_EQ(scene.code, GLINT_ERROR_NOT_FOUND);
    ASSERT_NE(scene.get(), nullptr);
    EXPECT_NE(scene.message().find("there/is/no/such.sdl"), std::string::npos) << scene.message();

    // Everything else refuses it.
    auto info = to_fill<glint_scene_info>();
    EXPECT_EQ(glint_scene_get_info(scene.get(), &info), GLINT_ERROR_INVALID_ARGUMENT);
    const auto renderer = renderer_of(scene.get());
    EXPECT_EQ(renderer.code, GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(renderer.message(), "there is no scene");
    const auto framebuffer = framebuffer_of(8, 8);
    EXPECT_EQ(glint_renderer_render(renderer.get(), framebuffer.get(), nullptr, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(renderer.message(), "there is no scene"); // why it was not made stays
}

TEST(CErrors, a_handle_keeps_the_message_of_its_last_failure) {
    const auto room = read_room();
    ASSERT_EQ(room.code, GLINT_OK) << room.message();
    const auto renderer = renderer_of(room.get());
    const auto framebuffer = framebuffer_of(8, 8);
    EXPECT_EQ(renderer.message(), "");
    EXPECT_EQ(glint_renderer_render(renderer.get(), nullptr, nullptr, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(renderer.message(), "there is no framebuffer");
    EXPECT_EQ(glint_renderer_render(renderer.get(), framebuffer.get(), nullptr, nullptr), GLINT_OK);
    EXPECT_EQ(renderer.message(), "there is no framebuffer");
    EXPECT_STREQ(glint_last_error_message(nullptr), "there is no handle");
}

TEST(CErrors, a_handle_of_another_kind_is_refused) {
    const auto room = read_room();
    const auto framebuffer = framebuffer_of(8, 8);
    auto *const not_a_scene = reinterpret_cast<glint_scene *>(framebuffer.get());
    auto info = to_fill<glint_scene_info>();
    EXPECT_EQ(glint_scene_get_info(not_a_scene, &info), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(renderer_of(not_a_scene).code, GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_job_wait(reinterpret_cast<glint_job *>(framebuffer.get()), nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    glint_scene_release(not_a_scene); // nothing happens
    auto pixels = to_fill<glint_pixels>();
    EXPECT_EQ(glint_framebuffer_get_pixels(framebuffer.get(), &pixels), GLINT_OK);
}

TEST(CErrors, null_is_released_without_a_word) {
    for (int i = 0; i < 2; ++i) {
        Release()(static_cast<glint_scene *>(nullptr));
        Release()(static_cast<glint_scene_builder *>(nullptr));
        Release()(static_cast<glint_framebuffer *>(nullptr));
        Release()(static_cast<glint_renderer *>(nullptr));
        Release()(static_cast<glint_job *>(nullptr));
        Release()(static_cast<glint_governor *>(nullptr));
        Release()(static_cast<glint_camera_control *>(nullptr));
        Release()(static_cast<glint_refiner *>(nullptr));
        glint_task_release(nullptr);
        glint_task_run(nullptr);
    }
}

/// Options with something behind what this library knows.
struct Later {
    glint_render_options known = with_defaults(glint_render_options_init);
    uint64_t news[2] = {};
};

TEST(CStructs, of_a_later_version_the_unknown_rest_must_be_zero) {
    const auto room = read_room();
    const auto renderer = renderer_of(room.get());
    const auto framebuffer = framebuffer_of(8, 8);
    const auto render = [&](const Later &later) {
        return glint_renderer_render(renderer.get(), framebuffer.get(), &later.known, nullptr);
    };
    Later later;
    later.known.size = sizeof later;
    EXPECT_EQ(render(later), GLINT_OK);
    later.news[1] = 1;
    EXPECT_EQ(render(later), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(renderer.message(), "the options are not a valid struct: see their size");
}

TEST(CStructs, of_an_earlier_version_the_missing_rest_is_default) {
    const auto room = read_room();
    const auto renderer = renderer_of(room.get());
    const auto framebuffer = framebuffer_of(8, 8);
    glint_render_options earlier = with_defaults(glint_render_options_init);
    earlier.max_depth = -7; // behind the end
    earlier.size = offsetof(glint_render_options, max_depth);
    EXPECT_EQ(glint_renderer_render(renderer.get(), framebuffer.get(), &earlier, nullptr), GLINT_OK);
    earlier.size = sizeof earlier;
    EXPECT_EQ(glint_renderer_render(renderer.get(), framebuffer.get(), &earlier, nullptr),
              GLINT_ERROR_INVALID_ARGUMENT);
}

TEST(CStructs, a_size_that_is_none_is_refused) {
    const auto room = read_room();
    std::vector<uint64_t> memory(1024, 0);
    for (const size_t size : {size_t{0}, size_t{4}, size_t{12}, size_t{4104}, SIZE_MAX}) {
        std::memcpy(memory.data(), &size, sizeof size);
        EXPECT_EQ(glint_scene_get_info(room.get(), reinterpret_cast<glint_scene_info *>(memory.data())),
                  GLINT_ERROR_INVALID_ARGUMENT)
            << size;
        EXPECT_EQ(glint_render_options_init(reinterpret_cast<glint_render_options *>(memory.data()), size),
                  GLINT_ERROR_INVALID_ARGUMENT)
            << size;
    }
}

TEST(CStructs, are_filled_up_to_their_size_and_with_zeroes_behind_what_is_known) {
    const auto room = read_room();
    struct {
        glint_scene_info known;
        uint64_t news[2];
    } later;
    std::memset(&later, 0xa5, sizeof later);
    later.known.size = sizeof later.known + sizeof(uint64_t);
    ASSERT_EQ(glint_scene_get_info(room.get(), &later.known), GLINT_OK);
    EXPECT_EQ(later.known.size, sizeof later.known + sizeof(uint64_t));
    EXPECT_EQ(later.known.objects, 1u);
    EXPECT_EQ(later.news[0], 0u);
    EXPECT_EQ(later.news[1], 0xa5a5a5a5a5a5a5a5u);

    std::memset(&later, 0xa5, sizeof later);
    later.known.size = offsetof(glint_scene_info, objects);
    ASSERT_EQ(glint_scene_get_info(room.get(), &later.known), GLINT_OK);
    EXPECT_STREQ(later.known.output_file, "");
    EXPECT_EQ(later.known.objects, 0xa5a5a5a5u);
}

TEST(CStructs, what_is_reserved_must_be_zero) {
    const auto room = read_room();
    glint_renderer_options options = with_defaults(glint_renderer_options_init);
    options.reserved = 1;
    EXPECT_EQ(make<glint_renderer>([&](glint_renderer **place) {
                  return glint_renderer_create(room.get(), &options, place);
              }).code,
              GLINT_ERROR_INVALID_ARGUMENT);
}

} // namespace
} // namespace glint::test
