// Renders that go on while their caller does other things.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <optional>

#include <glint/glint.hpp>

#include "host/hosts.hpp"

namespace glint::test {
namespace {

using namespace std::chrono_literals;

std::shared_ptr<const Scene> scene_named(const char *name) {
    const auto file = read_scene(GLINT_SOURCE_DIR "/" + std::string(name) + ".sdl");
    if (!file) throw std::runtime_error(file.error().text());
    return file->scene;
}

/// Jobs on threads of one kind.
class Jobs : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        if (GetParam() == "pool") pool_.emplace(2), options_.submit = pool_->submit();
        if (GetParam() == "lazy") options_.submit = lazy_.submit();
        for (const NamedHost &host : hosts_without_threads()) {
            if (host.name == GetParam()) options_.submit = host.submit;
        }
        renderer_.emplace(Accel::build(scene_named("tests/sdl/good/glint_mirror_hall")), options_);
        Framebuffer picture = make();
        EXPECT_TRUE(renderer_->render(picture));
        expected_ = picture.radiance_hash();
    }
    [[nodiscard]] static Framebuffer make(uint32_t size = 160) {
        return std::move(Framebuffer::create(size, size)).value();
    }
    /// Whether somebody traces without being waited for.
    [[nodiscard]] bool goes_on_alone() const {
        return GetParam() == "own" || GetParam() == "one" || GetParam() == "pool" || GetParam() == "at once" ||
               GetParam() == "twice";
    }

    LazyHost lazy_;
    std::optional<HostPool> pool_;
    RendererOptions options_{GetParam() == "one" ? 1u : 3u};
    std::optional<Renderer> renderer_;
    uint64_t expected_ = 0;
};

TEST_P(Jobs, give_the_picture_and_the_statistics_of_render) {
    Framebuffer blocking = make(), picture = make();
    const auto expected = renderer_->render(blocking);
    auto job = renderer_->start(picture);
    ASSERT_TRUE(job);
    for (int time = 0; time < 2; ++time) {
        const auto result = job->wait();
        ASSERT_TRUE(result);
        EXPECT_EQ(result->rays(), expected->rays());
        EXPECT_GT(result->seconds, 0.0);
    }
    EXPECT_TRUE(job->is_done());
    EXPECT_EQ(job->progress(), 1.0);
    EXPECT_EQ(picture.radiance_hash(), expected_);
}

TEST_P(Jobs, come_to_their_end_alone_where_threads_are_lent) {
    if (!goes_on_alone()) GTEST_SKIP() << "this host runs no task by itself";
    Framebuffer picture = make();
    auto job = renderer_->start(picture);
    ASSERT_TRUE(job);
    while (!job->is_done()) std::this_thread::sleep_for(1ms);
    EXPECT_EQ(picture.radiance_hash(), expected_);
}

TEST_P(Jobs, can_be_dropped_at_any_moment) {
    Framebuffer picture = make();
    for (int time = 0; time < 30; ++time) {
        auto job = renderer_->start(picture);
        ASSERT_TRUE(job);
        std::this_thread::sleep_for(time * 50us);
    }
    Framebuffer after = make();
    ASSERT_TRUE(renderer_->render(after));
    EXPECT_EQ(after.radiance_hash(), expected_);
}

TEST_P(Jobs, can_be_cancelled) {
    Framebuffer picture = make(1000);
    auto job = renderer_->start(picture);
    ASSERT_TRUE(job);
    const bool was_done = job->is_done(); // within start(), by a host that runs tasks at once
    job->cancel();
    const auto result = job->wait();
    EXPECT_TRUE(job->is_done());
    EXPECT_EQ(result.ok(), job->progress() == 1.0);
    if (was_done) return;
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_EQ(job->wait().error().code, ErrorCode::cancelled);
}

TEST_P(Jobs, are_finished_by_the_next_render) {
    Framebuffer first = make(), second = make(), third = make();
    auto job = renderer_->start(first);
    ASSERT_TRUE(job);
    ASSERT_TRUE(renderer_->render(second));
    EXPECT_TRUE(job->is_done());
    EXPECT_EQ(first.radiance_hash(), expected_);
    EXPECT_EQ(second.radiance_hash(), expected_);
    auto next = renderer_->start(third);
    ASSERT_TRUE(next);
    renderer_->set_accel(Accel::build(scene_named("scenes/sdl/cornell")));
    EXPECT_TRUE(next->is_done());
    EXPECT_EQ(third.radiance_hash(), expected_);
}

TEST_P(Jobs, tell_once_when_they_are_done) {
    Framebuffer picture = make();
    std::atomic<int> told{0};
    for (int time = 1; time <= 20; ++time) {
        auto job = renderer_->start(picture, {}, [&] { ++told; });
        ASSERT_TRUE(job);
        if (time % 3 == 0) job->cancel();
        (void)job->wait();
        EXPECT_EQ(told, time) << "before wait() returns";
    }
    for (int time = 1; time <= 20; ++time) {
        ASSERT_TRUE(renderer_->start(picture, {}, [&] { ++told; }));
        EXPECT_EQ(told, 20 + time) << "before the destructor does";
    }
}

TEST_P(Jobs, start_the_next_one_when_they_are_done) {
    constexpr int frames = 10;
    Framebuffer picture = make(64);
    std::vector<std::optional<RenderJob>> jobs(frames);
    std::atomic<int> done{0}, kept{0};
    std::function<void()> next = [&] {
        const int frame = ++done;
        if (frame == frames) return;
        auto job = renderer_->start(picture, {}, next);
        if (job) jobs[static_cast<size_t>(frame)].emplace(std::move(job).value());
        ++kept;
    };
    auto first = renderer_->start(picture, {}, next);
    ASSERT_TRUE(first);
    if (goes_on_alone()) {
        while (done < frames || kept < frames - 1) std::this_thread::sleep_for(1ms);
    }
    ASSERT_TRUE(first->wait());
    for (size_t frame = 1; frame < frames; ++frame) {
        ASSERT_TRUE(jobs[frame]) << frame;
        ASSERT_TRUE(jobs[frame]->wait());
    }
    EXPECT_EQ(done, frames);
}

TEST_P(Jobs, drop_what_is_thrown_at_the_end) {
    Framebuffer picture = make();
    auto job = renderer_->start(picture, {}, [] { throw std::runtime_error("nobody listens"); });
    ASSERT_TRUE(job);
    EXPECT_TRUE(job->wait());
}

TEST_P(Jobs, can_be_moved) {
    Framebuffer picture = make();
    auto started = renderer_->start(picture);
    ASSERT_TRUE(started);
    RenderJob job = std::move(started).value();
    auto other = renderer_->start(picture);
    ASSERT_TRUE(other);
    job = std::move(other).value();
    EXPECT_TRUE(job.wait());
    EXPECT_EQ(picture.radiance_hash(), expected_);
}

TEST_P(Jobs, refuse_what_render_refuses) {
    Framebuffer picture = make();
    RenderOptions options;
    options.samples_per_pixel = 0;
    int told = 0;
    const auto job = renderer_->start(picture, options, [&] { ++told; });
    ASSERT_FALSE(job);
    EXPECT_EQ(job.error().code, ErrorCode::bad_input);
    EXPECT_EQ(told, 0);
}

INSTANTIATE_TEST_SUITE_P(Hosts, Jobs,
                         testing::Values("own", "one", "pool", "lazy", "at once", "twice", "never", "refused"),
                         [](const auto &kind) {
                             std::string name = kind.param;
                             for (char &c : name) c = c == ' ' ? '_' : c;
                             return name;
                         });

TEST(JobsOfALazyHost, are_left_alone_by_tasks_that_come_too_late) {
    LazyHost host;
    {
        Renderer renderer(Accel::build(scene_named("scenes/sdl/cornell")), {3, best_isa(), host.submit()});
        auto picture = Framebuffer::create(64, 64);
        auto job = renderer.start(*picture);
        ASSERT_TRUE(job);
        EXPECT_EQ(host.count(), 3u) << "the caller need not help";
        EXPECT_FALSE(job->is_done());
        EXPECT_TRUE(job->wait());
    }
    host.run_all(); // sanitizers would see what they touch
}

TEST(JobsOfALazyHost, are_done_by_its_tasks) {
    LazyHost host;
    Renderer renderer(Accel::build(scene_named("scenes/sdl/cornell")), {3, best_isa(), host.submit()});
    auto picture = Framebuffer::create(64, 64);
    int told = 0;
    auto job = renderer.start(*picture, {}, [&] { ++told; });
    ASSERT_TRUE(job);
    host.run_all();
    EXPECT_TRUE(job->is_done());
    EXPECT_EQ(told, 1);
}

} // namespace
} // namespace glint::test
