// Rendering and building on threads that the host lends: the same results whatever it does with the tasks, and no
// thread of the library's own.
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <set>

#include <glint/glint.hpp>

#include "host/hosts.hpp"
#include "support/meshes.hpp"
#include "support/picture.hpp"
#include "threads/parallel_for.hpp"

namespace glint::test {
namespace {

const std::string cornell = GLINT_SOURCE_DIR "/scenes/sdl/cornell.sdl";

std::shared_ptr<const Scene> cornell_scene() {
    const auto file = read_scene(cornell);
    if (!file) throw std::runtime_error(file.error().text());
    return file->scene;
}

/// Of a picture of 100 x 75 pixels.
uint64_t hash_of(Renderer &renderer) {
    auto picture = Framebuffer::create(100, 75);
    const auto result = renderer.render(*picture);
    return result ? picture->radiance_hash() : 0;
}

uint64_t expected_hash(const std::shared_ptr<const Scene> &scene) {
    Renderer renderer(Accel::build(scene, {AccelKind::automatic, 1}), {1});
    return hash_of(renderer);
}

TEST(HostThreads, need_not_run_a_task_to_render) {
    const auto scene = cornell_scene();
    const uint64_t expected = expected_hash(scene);
    for (const NamedHost &host : hosts_without_threads()) {
        Renderer renderer(Accel::build(scene, {AccelKind::kdtree, 3, host.submit}), {3, best_isa(), host.submit});
        EXPECT_EQ(renderer.threads(), 3u);
        for (int frame = 0; frame < 3; ++frame) EXPECT_EQ(hash_of(renderer), expected) << host.name;
    }
}

TEST(HostThreads, get_a_task_for_each_further_thread) {
    LazyHost host;
    Renderer renderer(Accel::build(cornell_scene()), {4, best_isa(), host.submit()});
    EXPECT_EQ(host.count(), 0u) << "nobody works on nothing";
    hash_of(renderer);
    EXPECT_EQ(host.count(), 3u);
}

TEST(HostThreads, may_run_tasks_when_all_is_over) {
    LazyHost host;
    {
        Renderer renderer(Accel::build(cornell_scene(), {AccelKind::kdtree, 4, host.submit()}),
                          {4, best_isa(), host.submit()});
        hash_of(renderer);
        EXPECT_GT(host.count(), 0u);
    }
    host.run_all(); // sanitizers would see what they touch
}

TEST(HostThreads, take_part) {
    const auto scene = cornell_scene();
    const uint64_t expected = expected_hash(scene);
    HostPool pool(2);
    Renderer renderer(Accel::build(scene), {3, best_isa(), pool.submit()});
    for (int frame = 0; frame < 50; ++frame) ASSERT_EQ(hash_of(renderer), expected);
}

TEST(HostThreads, all_work_on_a_loop) {
    HostPool pool(3);
    const SubmitTask submit = pool.submit();
    std::atomic<int> joined{0};
    parallel_for(4, Crew(4, submit), [&](size_t, unsigned thread) {
        EXPECT_LT(thread, 4u);
        // Whoever is in waits for the others: this ends only when all four have joined.
        for (++joined; joined.load() < 4;) std::this_thread::yield();
    });
    EXPECT_EQ(joined, 4);
}

TEST(HostThreads, bring_a_loops_exception_to_the_caller) {
    HostPool pool(2);
    const SubmitTask submit = pool.submit();
    for (int time = 0; time < 100; ++time) {
        EXPECT_THROW(parallel_for(1000, Crew(3, submit),
                                  [](size_t i, unsigned) {
                                      if (i % 7 == 3) throw std::bad_alloc();
                                  }),
                     std::bad_alloc);
    }
}

TEST(HostThreads, build_the_same_trees) {
    HostPool pool(2);
    const auto scene = scene_of(terrain(80));
    for (const AccelKind kind : {AccelKind::kdtree, AccelKind::bvh}) {
        const auto own = Accel::build(scene, {kind, 1});
        std::vector<NamedHost> hosts = hosts_without_threads();
        hosts.push_back({"pool", pool.submit()});
        for (const NamedHost &host : hosts) {
            const auto lent = Accel::build(scene, {kind, 3, host.submit});
            EXPECT_EQ(lent->statistics().nodes, own->statistics().nodes) << host.name;
            EXPECT_EQ(lent->statistics().sah_cost, own->statistics().sah_cost) << host.name;
            Renderer renderer(lent, {1}), expected(own, {1});
            EXPECT_EQ(hash_of(renderer), hash_of(expected)) << host.name;
        }
    }
}

TEST(HostThreads, refine_a_picture) {
    HostPool pool(2);
    const auto accel = Accel::build(cornell_scene());
    Renderer lent(accel, {3, best_isa(), pool.submit()}), own(accel, {2});
    Refiner a, b;
    auto from_lent = Framebuffer::create(200, 150), from_own = Framebuffer::create(200, 150);
    while (!a.done()) {
        ASSERT_TRUE(a.next(lent, *from_lent));
        ASSERT_TRUE(b.next(own, *from_own));
        ASSERT_EQ(from_lent->radiance_hash(), from_own->radiance_hash());
    }
}

#if defined(__linux__)

/// The threads of this process.
std::set<std::string> threads_now() {
    std::set<std::string> threads;
    std::error_code gone; // a thread may end while its folder is looked at
    for (const auto &entry : std::filesystem::directory_iterator("/proc/self/task", gone)) {
        threads.insert(entry.path().filename());
    }
    return threads;
}

/// Whether a thread that was not there before was seen while `work` ran.
template <typename Work> bool starts_threads(Work &&work) {
    std::atomic<bool> begin{false}, end{false};
    std::set<std::string> known, seen;
    std::thread watcher([&] {
        while (!begin.load()) std::this_thread::yield();
        while (!end.load()) seen.merge(threads_now());
    });
    known = threads_now();
    begin = true;
    work();
    end = true;
    watcher.join();
    seen.merge(threads_now());
    return !std::includes(known.begin(), known.end(), seen.begin(), seen.end());
}

/// Everything that may take threads, so often that a watcher sees them.
void use_all(const SubmitTask &submit) {
    for (int time = 0; time < 10; ++time) {
        const auto file = read_scene(cornell);
        ASSERT_TRUE(file);
        const auto large = Accel::build(scene_of(terrain(80)), {AccelKind::automatic, 3, submit});
        Renderer renderer(Accel::build(file->scene, {AccelKind::kdtree, 3, submit}), {3, best_isa(), submit});
        auto picture = Framebuffer::create(200, 200);
        ASSERT_TRUE(renderer.render(*picture));
        auto job = renderer.start(*picture);
        ASSERT_TRUE(job);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ASSERT_TRUE(job->wait());
        Refiner refiner;
        for (int pass = 0; pass < 3; ++pass) ASSERT_TRUE(refiner.next(renderer, *picture));
    }
}

TEST(HostThreads, are_the_only_ones) {
    HostPool pool(2);
    EXPECT_FALSE(starts_threads([&] { use_all(pool.submit()); }));
}

TEST(OwnThreads, would_be_seen) {
    EXPECT_TRUE(starts_threads([] { use_all({}); }));
}

#endif

} // namespace
} // namespace glint::test
