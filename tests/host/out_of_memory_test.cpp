// Memory and threads run out at every place where they may: the caller is told, nothing is lost, nobody hangs. A
// program of its own, because it counts every allocation.
#include <gtest/gtest.h>

#include <cstring>
#include <new>
#include <optional>

#include <glint/glint.hpp>

#include "host/failing_memory.hpp"
#include "host/hosts.hpp"

namespace glint::test {
namespace {

/// How something ended, told without asking for memory.
struct Ending {
    enum Kind { good, out_of_memory, bad_alloc, other } kind = good;
    char words[200] = "";

    static Ending of(const Error &error) {
        Ending ending{error.code == ErrorCode::out_of_memory ? out_of_memory : other};
        std::strncpy(ending.words, error.diagnostics.front().message.c_str(), sizeof ending.words - 1);
        return ending;
    }
    static Ending of(const char *complaint) {
        Ending ending{other};
        std::strncpy(ending.words, complaint, sizeof ending.words - 1);
        return ending;
    }
};

/// Has work() run out of memory at its first allocation, at its second, ..., until it needs no more: once, and for
/// good. What it does must not depend on what it did before; settle() waits for whoever is still at it.
template <typename Work, typename Settle> void run_out_everywhere(Work &&work, Settle &&settle) {
    ASSERT_EQ(work().kind, Ending::good) << work().words;
    settle();
    for (const bool for_good : {false, true}) {
        for (int64_t first = 1;; ++first) {
            const int64_t before = live_allocations();
            Ending ending;
            bool has_failed = false;
            {
                const FailingMemory memory(first, for_good);
                try {
                    ending = work();
                } catch (const std::bad_alloc &) {
                    ending.kind = Ending::bad_alloc;
                }
                has_failed = FailingMemory::has_failed();
            }
            settle();
            ASSERT_EQ(live_allocations(), before) << "leaked when allocation " << first << " failed";
            ASSERT_NE(ending.kind, Ending::other) << "allocation " << first << ": " << ending.words;
            if (!has_failed) {
                ASSERT_EQ(ending.kind, Ending::good) << ending.words;
                EXPECT_GT(first, 20) << "so little memory was asked for that hardly anything was tried";
                testing::Test::RecordProperty(for_good ? "for_good" : "once", std::to_string(first - 1));
                break;
            }
        }
    }
}

std::filesystem::path file_of(const char *scene) {
    return std::string(GLINT_SOURCE_DIR "/tests/sdl/good/") + scene + ".sdl";
}

ReadOptions reading() {
    ReadOptions options;
    options.read_texture = [](const std::filesystem::path &) { return Texture{1, 1, {Color(0.5f)}}; };
    return options;
}

/// Meshes with materials; quadrics and glass; moving objects.
const char *const scenes[] = {"mobile2013_gem", "glint_fresnel", "glint_moving"};

class OutOfMemory : public testing::TestWithParam<const char *> {};

TEST_P(OutOfMemory, while_a_scene_is_read) {
    const auto options = reading();
    const auto file = file_of(GetParam());
    run_out_everywhere(
        [&] {
            const auto scene = read_scene(file, options);
            return scene ? Ending() : Ending::of(scene.error());
        },
        [] {});
}

TEST_P(OutOfMemory, while_a_scene_is_converted) {
    const auto options = reading();
    const auto file = file_of(GetParam());
    run_out_everywhere(
        [&] {
            const auto scene = convert_scene(file, file.parent_path(), options);
            return scene ? Ending() : Ending::of(scene.error());
        },
        [] {});
}

constexpr uint32_t width = 20, height = 17;

/// Everything that comes after reading. What fails for lack of memory is done once more: nothing may have been broken.
class Rendering {
public:
    Rendering(std::shared_ptr<const Scene> scene, const SubmitTask &submit)
        : scene_(std::move(scene)), submit_(submit) {
        Renderer renderer(Accel::build(scene_, {AccelKind::brute, 1}), {1});
        auto picture = Framebuffer::create(width, height);
        if (renderer.render(*picture)) expected_ = picture->radiance_hash();
    }

    Ending operator()() {
        const auto accel = Accel::build(scene_, {AccelKind::automatic, 3, submit_});
        const auto bvh = Accel::build(scene_, {AccelKind::bvh, 3, submit_});
        Renderer renderer(accel, {3, best_isa(), submit_});
        auto picture = Framebuffer::create(width, height);
        if (!picture) return Ending::of(picture.error());
        if (const Ending ending = render(renderer, *picture); ending.kind != Ending::good) return ending;
        if (const Ending ending = start(renderer, *picture); ending.kind != Ending::good) return ending;

        Renderer scalar(bvh, {2, Isa::scalar, submit_});
        if (const Ending ending = render(scalar, *picture); ending.kind != Ending::good) return ending;
        Refiner refiner;
        for (int pass = 0; pass < 3; ++pass) {
            auto refined = refiner.next(renderer, *picture);
            if (!refined && refined.error().code == ErrorCode::out_of_memory)
                refined = refiner.next(renderer, *picture);
            if (!refined) return Ending::of(refined.error());
        }
        const auto tree = trace_ray_tree(*accel, {}, width, height, 9, 8);
        if (!tree) return Ending::of(tree.error());
        auto later = scene_at(scene_, 0.5);
        if (!later) return Ending::of(later.error());
        renderer.set_accel(Accel::update(accel, *later));
        const auto moved = renderer.render(*picture);
        return moved ? Ending() : Ending::of(moved.error());
    }

private:
    Ending checked(const Result<RenderStatistics> &result, const Framebuffer &picture) const {
        if (!result) return Ending::of(result.error());
        return picture.radiance_hash() == expected_ ? Ending() : Ending::of("the picture is another one");
    }
    Ending render(Renderer &renderer, Framebuffer &picture) const {
        auto result = renderer.render(picture);
        if (!result && result.error().code == ErrorCode::out_of_memory) result = renderer.render(picture);
        return checked(result, picture);
    }
    Ending start(Renderer &renderer, Framebuffer &picture) const {
        int told = 0;
        auto job = renderer.start(picture, {}, [&told] { ++told; });
        if (!job) return Ending::of(job.error());
        const auto result = job->wait();
        if (told != 1) return Ending::of("the end was not told once");
        return checked(result, picture);
    }

    std::shared_ptr<const Scene> scene_;
    const SubmitTask &submit_;
    uint64_t expected_ = 0;
};

std::shared_ptr<const Scene> scene_named(const char *name) {
    const auto file = read_scene(file_of(name), reading());
    if (!file) throw std::runtime_error(file.error().text());
    return file->scene;
}

TEST_P(OutOfMemory, while_own_threads_render) {
    const SubmitTask none;
    run_out_everywhere(Rendering(scene_named(GetParam()), none), [] {});
}

TEST_P(OutOfMemory, while_a_hosts_threads_render) {
    HostPool pool(2);
    const SubmitTask submit = pool.submit();
    run_out_everywhere(Rendering(scene_named(GetParam()), submit), [&] { pool.drain(); });
}

INSTANTIATE_TEST_SUITE_P(Scenes, OutOfMemory, testing::ValuesIn(scenes),
                         [](const auto &scene) { return std::string(scene.param); });

TEST(OutOfMemory, while_files_come_from_the_program) {
    const auto files = std::make_shared<MemoryFiles>();
    files->add("room/lamp.obj", "v -1 4 0\nv 1 4 0\nv 0 4 1\nf 1 2 3\n")
        .add("house.obj", "mtllib house.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 .5\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
                          "usemtl red\nf 1/1/1 2/2/1 3/3/1 4/2/1\n")
        .add("house.mtl", "newmtl red\nKd 1 0 0\nKs .5 .5 .5\nmap_Kd x.png\n")
        .add("x.png", "pixels");
    ReadOptions options;
    options.files = files;
    options.scene_root = ".";
    options.decode_texture = [](std::string_view, const std::string &) { return Texture{1, 1, {Color(0.5f)}}; };
    const std::string text = "eye 0 0 5\nreflections 3\nlight lamp.obj 1 1 1 1\nobject ../house.obj mtl\n";
    run_out_everywhere(
        [&] {
            const auto scene = read_scene_text(text, "room/scene.sdl", options);
            return scene ? Ending() : Ending::of(scene.error());
        },
        [] {});
}

#ifndef GLINT_SANITIZED

TEST(OutOfThreads, there_are_fewer_and_the_picture_is_the_same) {
    const SubmitTask none;
    const auto scene = scene_named("glint_moving");
    Rendering rendering(scene, none);
    for (int64_t count = 0; count < 12; ++count) {
        const FewThreads threads(count);
        const Ending ending = rendering();
        EXPECT_EQ(ending.kind, Ending::good) << ending.words;
    }
    const FewThreads threads(1);
    EXPECT_EQ(Renderer(Accel::build(scene, {AccelKind::kdtree, 1}), {4}).threads(), 2u);
}

TEST(OutOfThreads, a_job_waits_for_who_waits_for_it) {
    Renderer renderer(Accel::build(scene_named("glint_moving")), {1});
    auto first = Framebuffer::create(width, height), second = Framebuffer::create(width, height);
    const FewThreads threads(0);
    auto job = renderer.start(*first);
    ASSERT_TRUE(job);
    EXPECT_FALSE(job->is_done());
    ASSERT_TRUE(renderer.render(*second));
    EXPECT_TRUE(job->is_done()) << "the next render finishes it";
    EXPECT_EQ(first->radiance_hash(), second->radiance_hash());
    ASSERT_TRUE(renderer.start(*first)) << "and it can be dropped";
}

#endif

} // namespace
} // namespace glint::test
