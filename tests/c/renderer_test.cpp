// Pictures through the C interface: the bytes that C++ gets, in whose memory and on whose threads ever.
#include <atomic>
#include <cmath>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

#include <glint/read.hpp>
#include <glint/renderer.hpp>

#include "c/c_handles.hpp"

namespace glint::test {
namespace {

constexpr const char *cornell_file = GLINT_SOURCE_DIR "/scenes/sdl/cornell.sdl";

Made<glint_scene> read_cornell() {
    return make<glint_scene>([](glint_scene **place) { return glint_scene_read(cornell_file, nullptr, place); });
}

uint64_t hash_in_cpp(uint32_t width_px, uint32_t height_px, const RenderOptions &options) {
    auto file = read_scene(cornell_file);
    auto picture = Framebuffer::create(width_px, height_px);
    Renderer renderer(Accel::build(file->scene));
    EXPECT_TRUE(renderer.render(*picture, options).ok());
    return picture->pixel_hash();
}

class CRenderer : public testing::Test {
protected:
    Made<glint_scene> scene = read_cornell();
    Made<glint_renderer> renderer = renderer_of(scene.get());
    Made<glint_framebuffer> picture = framebuffer_of(96, 64);

    Made<glint_job> start(glint_done_function on_done = nullptr, void *user = nullptr) {
        return make<glint_job>([&](glint_job **place) {
            return glint_renderer_start(renderer.get(), picture.get(), nullptr, on_done, user, place);
        });
    }
};

TEST_F(CRenderer, renders_the_bytes_that_cpp_renders) {
    glint_render_options options = with_defaults(glint_render_options_init);
    options.max_depth = 3;
    options.samples_per_pixel = 2;
    options.pattern = GLINT_PATTERN_STRATIFIED;
    options.transfer = GLINT_TRANSFER_SRGB;
    auto statistics = to_fill<glint_render_statistics>();
    ASSERT_EQ(glint_renderer_render(renderer.get(), picture.get(), &options, &statistics), GLINT_OK);
    RenderOptions same;
    same.max_depth = 3;
    same.samples_per_pixel = 2;
    same.pattern = SamplePattern::stratified;
    same.transfer = Transfer::srgb;
    EXPECT_EQ(glint_framebuffer_pixel_hash(picture.get()), hash_in_cpp(96, 64, same));
    EXPECT_EQ(statistics.primary_rays, 2u * 96 * 64);
    EXPECT_GT(statistics.shadow_rays, 0u);
    EXPECT_GT(statistics.secondary_rays, 0u);
    EXPECT_GT(statistics.seconds, 0.0);
    EXPECT_EQ(glint_renderer_threads(renderer.get()), 2u);
}

TEST_F(CRenderer, renders_into_the_callers_memory_and_never_between_rows) {
    constexpr size_t stride = 4 * 96 + 12, float_stride = 12 * 96 + 8;
    std::vector<uint8_t> bytes(stride * 64, 0x77);
    std::vector<float> floats(float_stride / 4 * 64, -7.0f);
    const auto wrapped = make<glint_framebuffer>([&](glint_framebuffer **place) {
        return glint_framebuffer_wrap(96, 64, bytes.data(), stride, floats.data(), float_stride, place);
    });
    ASSERT_EQ(wrapped.code, GLINT_OK) << wrapped.message();
    auto pixels = to_fill<glint_pixels>();
    ASSERT_EQ(glint_framebuffer_get_pixels(wrapped.get(), &pixels), GLINT_OK);
    EXPECT_EQ(pixels.rgba8, bytes.data());
    EXPECT_EQ(pixels.stride_bytes, stride);
    EXPECT_EQ(pixels.radiance_stride_bytes, float_stride);
    ASSERT_EQ(glint_renderer_render(renderer.get(), wrapped.get(), nullptr, nullptr), GLINT_OK);
    ASSERT_EQ(glint_renderer_render(renderer.get(), picture.get(), nullptr, nullptr), GLINT_OK);
    EXPECT_EQ(glint_framebuffer_pixel_hash(wrapped.get()), glint_framebuffer_pixel_hash(picture.get()));
    for (size_t y = 0; y < 64; ++y) {
        EXPECT_EQ(bytes[y * stride + 4 * 96 - 1], 255);
        for (size_t x = 4 * 96; x < stride; ++x) EXPECT_EQ(bytes[y * stride + x], 0x77);
        EXPECT_EQ(floats[y * float_stride / 4 + 3 * 96], -7.0f);
    }
}

TEST_F(CRenderer, refuses_memory_that_cannot_hold_the_picture) {
    uint8_t byte[4] = {};
    const auto code = [&](uint32_t width_px, uint32_t height_px, uint8_t *memory, size_t stride) {
        return make<glint_framebuffer>([&](glint_framebuffer **place) {
                   return glint_framebuffer_wrap(width_px, height_px, memory, stride, nullptr, 0, place);
               })
            .code;
    };
    EXPECT_EQ(code(1, 1, byte, 0), GLINT_OK);
    EXPECT_EQ(code(1, 1, nullptr, 0), GLINT_ERROR_BAD_INPUT);
    EXPECT_EQ(code(0, 1, byte, 4), GLINT_ERROR_BAD_INPUT);
    EXPECT_EQ(code(1, 1, byte, 3), GLINT_ERROR_BAD_INPUT);
    EXPECT_EQ(code(1, UINT32_MAX, byte, SIZE_MAX), GLINT_ERROR_LIMIT_EXCEEDED);
    EXPECT_EQ(framebuffer_of(0, 5).code, GLINT_ERROR_BAD_INPUT);
    EXPECT_EQ(framebuffer_of(UINT32_MAX, UINT32_MAX).code, GLINT_ERROR_LIMIT_EXCEEDED);
}

TEST_F(CRenderer, refuses_options_that_are_none) {
    const auto code = [&](auto change) {
        glint_render_options options = with_defaults(glint_render_options_init);
        change(options);
        return glint_renderer_render(renderer.get(), picture.get(), &options, nullptr);
    };
    EXPECT_EQ(code([](auto &options) { options.max_depth = -2; }), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(code([](auto &options) { options.max_depth = 1001; }), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(code([](auto &options) { options.pattern = 3; }), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(code([](auto &options) { options.transfer = -1; }), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(code([](auto &options) { options.samples_per_pixel = 0; }), GLINT_ERROR_BAD_INPUT);
    EXPECT_EQ(code([](auto &options) { options.samples_per_pixel = 5000; }), GLINT_ERROR_BAD_INPUT);
    const glint_camera blind = {};
    EXPECT_EQ(code([&](auto &options) { options.camera = &blind; }), GLINT_ERROR_BAD_INPUT);
    EXPECT_GT(renderer.message().size(), 0u);
    const auto make_with = [&](auto change) {
        glint_renderer_options options = with_defaults(glint_renderer_options_init);
        change(options);
        return make<glint_renderer>(
                   [&](glint_renderer **place) { return glint_renderer_create(scene.get(), &options, place); })
            .code;
    };
    EXPECT_EQ(make_with([](auto &options) { options.isa = 17; }), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(make_with([](auto &options) { options.isa = GLINT_ISA_WASM; }), GLINT_ERROR_UNSUPPORTED);
    EXPECT_EQ(make_with([](auto &options) { options.accel = 4; }), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(make_with([](auto &options) { options.threads = 1025; }), GLINT_ERROR_INVALID_ARGUMENT);
}

TEST_F(CRenderer, traces_with_the_instruction_set_and_the_structure_asked_for) {
    ASSERT_EQ(glint_renderer_render(renderer.get(), picture.get(), nullptr, nullptr), GLINT_OK);
    const uint64_t hash = glint_framebuffer_pixel_hash(picture.get());
    for (const int32_t accel : {GLINT_ACCEL_KDTREE, GLINT_ACCEL_BVH, GLINT_ACCEL_BRUTE}) {
        glint_renderer_options options = with_defaults(glint_renderer_options_init);
        options.isa = GLINT_ISA_SCALAR;
        options.accel = accel;
        const auto scalar = make<glint_renderer>(
            [&](glint_renderer **place) { return glint_renderer_create(scene.get(), &options, place); });
        ASSERT_EQ(scalar.code, GLINT_OK) << scalar.message();
        EXPECT_STREQ(glint_isa_name(glint_renderer_isa(scalar.get())), "scalar");
        const auto other = framebuffer_of(96, 64);
        ASSERT_EQ(glint_renderer_render(scalar.get(), other.get(), nullptr, nullptr), GLINT_OK);
        EXPECT_EQ(glint_framebuffer_pixel_hash(other.get()), hash);
    }
    EXPECT_STREQ(glint_isa_name(-1), "");
    EXPECT_STREQ(glint_isa_name(6), "");
}

TEST_F(CRenderer, tells_what_is_under_a_finger) {
    auto pick = to_fill<glint_pick>();
    ASSERT_EQ(glint_renderer_pick(renderer.get(), nullptr, 0.5, 0.5, &pick), GLINT_OK) << renderer.message();
    EXPECT_TRUE(std::isfinite(pick.distance));
    auto object = to_fill<glint_object_info>();
    ASSERT_EQ(glint_scene_get_object(scene.get(), pick.object, &object), GLINT_OK);
    EXPECT_EQ(pick.light, GLINT_NONE);
    EXPECT_NEAR(std::hypot(pick.position[0], pick.position[1], pick.position[2] - 5.7), pick.distance, 1e-4);
    ASSERT_EQ(glint_renderer_pick(renderer.get(), nullptr, 5000.0, 0.5, &pick), GLINT_OK);
    EXPECT_TRUE(std::isinf(pick.distance));
    EXPECT_EQ(pick.object, GLINT_NONE);
    EXPECT_EQ(glint_renderer_pick(renderer.get(), nullptr, NAN, 0.5, &pick), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_renderer_pick(renderer.get(), nullptr, 0.5, 0.5, nullptr), GLINT_ERROR_INVALID_ARGUMENT);
}

TEST_F(CRenderer, goes_on_with_a_scene_that_has_moved_and_with_any_other) {
    const auto carousel = make<glint_scene>([](glint_scene **place) {
        return glint_scene_read(GLINT_SOURCE_DIR "/scenes/sdl/carousel.sdl", nullptr, place);
    });
    ASSERT_EQ(carousel.code, GLINT_OK) << carousel.message();
    const auto later =
        make<glint_scene>([&](glint_scene **place) { return glint_scene_at(carousel.get(), 0.7, place); });
    std::vector<uint64_t> hashes;
    for (const glint_scene *next : {scene.get(), carousel.get(), later.get()}) {
        ASSERT_EQ(glint_renderer_set_scene(renderer.get(), next), GLINT_OK);
        ASSERT_EQ(glint_renderer_render(renderer.get(), picture.get(), nullptr, nullptr), GLINT_OK);
        hashes.push_back(glint_framebuffer_pixel_hash(picture.get()));
        const auto fresh = renderer_of(next);
        const auto other = framebuffer_of(96, 64);
        ASSERT_EQ(glint_renderer_render(fresh.get(), other.get(), nullptr, nullptr), GLINT_OK);
        EXPECT_EQ(glint_framebuffer_pixel_hash(other.get()), hashes.back());
    }
    EXPECT_NE(hashes[1], hashes[2]);
}

TEST_F(CRenderer, a_job_renders_while_its_caller_watches) {
    std::atomic<int> told = 0;
    const auto job = start([](void *user) { ++*static_cast<std::atomic<int> *>(user); }, &told);
    ASSERT_EQ(job.code, GLINT_OK) << job.message();
    const double progress = glint_job_progress(job.get());
    EXPECT_GE(progress, 0.0);
    EXPECT_LE(progress, 1.0);
    auto statistics = to_fill<glint_render_statistics>();
    EXPECT_EQ(glint_job_wait(job.get(), &statistics), GLINT_OK);
    EXPECT_EQ(told, 1);
    EXPECT_EQ(glint_job_is_done(job.get()), 1);
    EXPECT_EQ(glint_job_progress(job.get()), 1.0);
    EXPECT_EQ(statistics.primary_rays, 96u * 64);
    EXPECT_EQ(glint_job_wait(job.get(), nullptr), GLINT_OK);
    EXPECT_EQ(glint_framebuffer_pixel_hash(picture.get()), hash_in_cpp(96, 64, {}));
}

TEST_F(CRenderer, a_cancelled_job_says_so) {
    picture = framebuffer_of(2048, 2048);
    const auto job = start();
    glint_job_cancel(job.get());
    EXPECT_EQ(glint_job_wait(job.get(), nullptr), GLINT_ERROR_CANCELLED);
    EXPECT_GT(job.message().size(), 0u);
    EXPECT_EQ(glint_job_is_done(job.get()), 1);
}

TEST_F(CRenderer, a_job_outlives_the_handles_that_it_was_started_with) {
    auto job = start();
    auto pixels = to_fill<glint_pixels>();
    ASSERT_EQ(glint_framebuffer_get_pixels(picture.get(), &pixels), GLINT_OK);
    scene.handle.reset();
    renderer.handle.reset();
    picture.handle.reset();
    EXPECT_EQ(glint_job_wait(job.get(), nullptr), GLINT_OK);
    EXPECT_EQ(pixels.rgba8[3], 255); // the job still has the picture
}

TEST_F(CRenderer, a_job_that_could_not_begin_is_a_handle_that_says_why) {
    picture.handle.reset();
    const auto job = start();
    EXPECT_EQ(job.code, GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(job.message(), "there is no framebuffer");
    EXPECT_EQ(glint_job_wait(job.get(), nullptr), GLINT_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glint_job_is_done(job.get()), 0);
    EXPECT_EQ(glint_job_progress(job.get()), 0.0);
    glint_job_cancel(job.get());
}

/// A host that lends threads, or keeps tasks until the end and never runs them.
struct Host {
    bool runs = true;
    std::mutex lock;
    std::vector<std::thread> threads;
    std::vector<glint_task *> kept;
    int tasks = 0;

    ~Host() {
        for (std::thread &thread : threads) thread.join();
        for (glint_task *task : kept) glint_task_release(task);
    }
    static void submit(void *user, glint_task *task) {
        auto &host = *static_cast<Host *>(user);
        const std::lock_guard guard(host.lock);
        ++host.tasks;
        if (host.runs)
            host.threads.emplace_back(glint_task_run, task);
        else
            host.kept.push_back(task);
    }
};

TEST_F(CRenderer, works_on_the_hosts_threads_and_without_any) {
    for (const bool runs : {true, false}) {
        Host host;
        host.runs = runs;
        glint_renderer_options options = with_defaults(glint_renderer_options_init);
        options.threads = 4;
        options.submit = Host::submit;
        options.submit_user = &host;
        renderer = make<glint_renderer>(
            [&](glint_renderer **place) { return glint_renderer_create(scene.get(), &options, place); });
        ASSERT_EQ(renderer.code, GLINT_OK) << renderer.message();
        ASSERT_EQ(glint_renderer_render(renderer.get(), picture.get(), nullptr, nullptr), GLINT_OK);
        EXPECT_EQ(glint_framebuffer_pixel_hash(picture.get()), hash_in_cpp(96, 64, {}));
        const auto job = start();
        EXPECT_EQ(glint_job_wait(job.get(), nullptr), GLINT_OK);
        renderer.handle.reset();
        EXPECT_GE(host.tasks, 3);
    }
}

} // namespace
} // namespace glint::test
