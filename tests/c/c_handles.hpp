// What tests of the C interface share: handles that release themselves, structs with their defaults, a small scene.
#pragma once

#include <cstring>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <glint/glint.h>

namespace glint::test {

/// Releases a handle, whatever its type.
struct Release {
    void operator()(glint_scene *handle) const { glint_scene_release(handle); }
    void operator()(glint_scene_builder *handle) const { glint_scene_builder_release(handle); }
    void operator()(glint_framebuffer *handle) const { glint_framebuffer_release(handle); }
    void operator()(glint_renderer *handle) const { glint_renderer_release(handle); }
    void operator()(glint_job *handle) const { glint_job_release(handle); }
    void operator()(glint_governor *handle) const { glint_governor_release(handle); }
    void operator()(glint_camera_control *handle) const { glint_camera_control_release(handle); }
    void operator()(glint_refiner *handle) const { glint_refiner_release(handle); }
};
template <typename H> using Owned = std::unique_ptr<H, Release>;

/// The handle that a creating function leaves as its last argument, and the code that it returns.
template <typename H> struct Made {
    Owned<H> handle;
    glint_error code;
    [[nodiscard]] H *get() const { return handle.get(); }
    [[nodiscard]] std::string message() const { return glint_last_error_message(handle.get()); }
};
/// `create` is called with the place for the handle.
template <typename H, typename Create> Made<H> make(Create &&create) {
    H *handle = nullptr;
    const glint_error code = create(&handle);
    return {Owned<H>(handle), code};
}

/// A struct with its defaults.
template <typename T> T with_defaults(glint_error (*init)(T *, size_t)) {
    T made;
    std::memset(&made, 0xa5, sizeof made);
    EXPECT_EQ(init(&made, sizeof made), GLINT_OK);
    return made;
}
/// A struct that the library fills.
template <typename T> T to_fill() {
    T made;
    std::memset(&made, 0xa5, sizeof made);
    made.size = sizeof made;
    return made;
}

/// A red floor below a lamp, before a blue background.
inline constexpr const char *room_text = "eye 0 0 5.7\nsize 48 32\northo -1 -1 1 1\nbackground 0 0 1\nambient 1\n"
                                         "max_depth 2\nlight lamp.obj 1 1 1 1\n"
                                         "object floor.obj 1 0 0 0.3 0.7 0 0 0.2 0\n";
inline constexpr const char *floor_text = "v -1 -0.8 -4\nv 1 -0.8 -4\nv 1 -0.8 -2\nv -1 -0.8 -2\nf 1 2 3\nf 1 3 4\n";
inline constexpr const char *lamp_text = "v -0.2 0.9 -4\nv 0.2 0.9 -4\nv 0.2 0.9 -2\nf 1 2 3\n";

/// The room, read from memory.
[[nodiscard]] inline Made<glint_scene> read_room() {
    const glint_memory_file files[] = {{"floor.obj", floor_text, std::strlen(floor_text)},
                                       {"lamp.obj", lamp_text, std::strlen(lamp_text)}};
    glint_read_options options = with_defaults(glint_read_options_init);
    options.memory_files = files;
    options.memory_file_count = 2;
    return make<glint_scene>([&](glint_scene **scene) {
        return glint_scene_read_text(room_text, std::strlen(room_text), "room.sdl", &options, scene);
    });
}

/// A renderer of it with so many threads.
[[nodiscard]] inline Made<glint_renderer> renderer_of(const glint_scene *scene, uint32_t threads = 2) {
    glint_renderer_options options = with_defaults(glint_renderer_options_init);
    options.threads = threads;
    return make<glint_renderer>([&](glint_renderer **place) { return glint_renderer_create(scene, &options, place); });
}

[[nodiscard]] inline Made<glint_framebuffer> framebuffer_of(uint32_t width_px, uint32_t height_px) {
    return make<glint_framebuffer>(
        [&](glint_framebuffer **place) { return glint_framebuffer_create(width_px, height_px, 0, place); });
}

} // namespace glint::test
