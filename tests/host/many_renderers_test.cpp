// A process with many renderers on the few threads of its host. ThreadSanitizer watches in the preset of its name.
#include <gtest/gtest.h>

#include <atomic>

#include <glint/glint.hpp>

#include "host/hosts.hpp"

namespace glint::test {
namespace {

TEST(Renderers, sixty_four_share_eight_threads_of_a_host) {
    constexpr size_t renderers = 64;
    struct Guest {
        std::unique_ptr<Renderer> renderer;
        Framebuffer picture;
        uint64_t expected;
    };
    const char *const names[] = {"scenes/sdl/cornell", "scenes/sdl/glass", "tests/sdl/good/glint_moving",
                                 "tests/sdl/good/glint_everything"};
    std::vector<std::shared_ptr<const Accel>> accels;
    std::vector<uint64_t> hashes;
    for (const char *name : names) {
        const auto file = read_scene(GLINT_SOURCE_DIR "/" + std::string(name) + ".sdl");
        ASSERT_TRUE(file);
        accels.push_back(Accel::build(file->scene));
        auto picture = Framebuffer::create(24, 16);
        ASSERT_TRUE(Renderer(accels.back(), {1}).render(*picture));
        hashes.push_back(picture->radiance_hash());
    }

    HostPool pool(8);
    std::vector<Guest> guests;
    for (size_t i = 0; i < renderers; ++i) {
        const size_t scene = i % std::size(names);
        guests.push_back({std::make_unique<Renderer>(accels[scene], RendererOptions{4, best_isa(), pool.submit()}),
                          std::move(Framebuffer::create(24, 16)).value(), hashes[scene]});
    }

    // From outside: all start jobs, some of which are cancelled.
    for (int frame = 0; frame < 2; ++frame) {
        std::vector<RenderJob> jobs;
        for (Guest &guest : guests) {
            auto job = guest.renderer->start(guest.picture);
            ASSERT_TRUE(job);
            jobs.push_back(std::move(job).value());
        }
        for (auto i = static_cast<size_t>(frame); i < renderers; i += 5) jobs[i].cancel();
        for (size_t i = 0; i < renderers; ++i) {
            if (!jobs[i].wait()) continue; // cancelled
            EXPECT_EQ(guests[i].picture.radiance_hash(), guests[i].expected);
        }
    }

    // From inside: the host's own threads render, and lend each other.
    std::atomic<size_t> left{renderers}, wrong{0};
    for (Guest &guest : guests) {
        pool.enqueue([&] {
            for (int frame = 0; frame < 2; ++frame) {
                const bool ok = guest.renderer->render(guest.picture).ok();
                if (!ok || guest.picture.radiance_hash() != guest.expected) ++wrong;
            }
            --left;
        });
    }
    while (left > 0) std::this_thread::yield();
    EXPECT_EQ(wrong, 0u);
}

} // namespace
} // namespace glint::test
