// The thread that traces: newest request first, frames whole, refinements stopped.
#include "viewer/frame_pipeline.hpp"

#include <thread>

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "support/picture.hpp"

namespace glint::viewer {
namespace {

constexpr auto long_enough = std::chrono::seconds(30);

std::shared_ptr<const Accel> accel() {
    SceneBuilder builder;
    builder.add_object({"square", test::square({0.0f, 0.0f, 0.0f}, 0.7f), {}});
    builder.set_ambient(0.5f);
    Material material;
    material.color = {0.2f, 0.6f, 1.0f};
    material.ambient = 1.0f;
    builder.add_object({"other", test::square({0.3f, 0.2f, 0.5f}, 0.3f), material});
    return Accel::build(*builder.build());
}

FrameRequest request(const std::shared_ptr<const Accel> &of, uint32_t size_px, bool refines = false) {
    FrameRequest request;
    request.accel = of;
    request.width_px = request.height_px = size_px;
    request.threads = 2;
    request.refines = refines;
    request.how.samples_per_pixel = 1;
    return request;
}

const Frame *next(FramePipeline &pipeline) {
    const Result<const Frame *> frame = pipeline.take(Clock::now() + long_enough);
    EXPECT_TRUE(frame.ok()) << (frame.ok() ? "" : frame.error().text());
    return frame.ok() ? *frame : nullptr;
}

TEST(FramePipeline, traces_what_render_traces) {
    const auto scene = accel();
    FramePipeline pipeline;
    pipeline.submit(request(scene, 64));
    const Frame *frame = next(pipeline);
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->picture->pixel_hash(), test::render(scene, 64, 64, 1, {}).pixel_hash());
    EXPECT_TRUE(frame->is_final);
    EXPECT_EQ(frame->number, 1u);
    EXPECT_GT(frame->statistics.primary_rays, 0u);
    EXPECT_TRUE(pipeline.is_idle());
    EXPECT_EQ(*pipeline.take(Clock::now()), nullptr);
}

TEST(FramePipeline, leaves_the_frame_that_is_shown_alone) {
    const auto scene = accel();
    FramePipeline pipeline;
    pipeline.submit(request(scene, 32));
    const Frame *shown = next(pipeline);
    const uint64_t hash = shown->picture->pixel_hash();
    for (uint32_t size = 33; size < 48; ++size) {
        pipeline.submit(request(scene, size));
        while (!pipeline.is_idle()) {
            if (const Frame *newer = *pipeline.take(Clock::now())) {
                EXPECT_NE(newer, shown);
                shown = newer;
                break;
            }
            EXPECT_EQ(shown->picture->pixel_hash(), hash) << "while " << size << " is being traced";
        }
        pipeline.submit(request(scene, 32));
        while (shown->request.width_px != 32) {
            if (const Frame *newer = *pipeline.take(Clock::now() + long_enough)) shown = newer;
        }
        EXPECT_EQ(shown->picture->pixel_hash(), hash);
    }
}

TEST(FramePipeline, refines_pass_by_pass_to_sixteen_samples) {
    const auto scene = accel();
    FramePipeline pipeline;
    pipeline.submit(request(scene, 64, true));
    std::vector<uint32_t> samples;
    const Frame *frame = nullptr;
    do {
        frame = next(pipeline);
        ASSERT_NE(frame, nullptr);
        samples.push_back(frame->samples);
    } while (!frame->is_final);
    EXPECT_EQ(samples.size(), Refiner::samples + 1u) << "every pass is shown";
    EXPECT_EQ(samples.back(), Refiner::samples);
    EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end()));
    auto wanted = Framebuffer::create(64, 64);
    RenderOptions smooth;
    smooth.samples_per_pixel = Refiner::samples;
    smooth.pattern = SamplePattern::centre;
    ASSERT_TRUE(Renderer(scene).render(*wanted, smooth).ok());
    EXPECT_EQ(frame->picture->pixel_hash(), wanted->pixel_hash());
    EXPECT_TRUE(pipeline.is_idle());
}

TEST(FramePipeline, gives_a_refinement_up_for_a_request) {
    const auto scene = accel();
    FramePipeline pipeline;
    for (int round = 0; round < 50; ++round) {
        pipeline.submit(request(scene, 256, true));
        if (round % 2 == 0) static_cast<void>(next(pipeline));
        pipeline.submit(request(scene, 16));
        const Frame *frame = next(pipeline);
        while (frame->request.refines) frame = next(pipeline); // finished before the request came
        EXPECT_EQ(frame->request.width_px, 16u);
        EXPECT_FALSE(frame->request.refines);
        EXPECT_TRUE(pipeline.is_idle());
    }
}

TEST(FramePipeline, tells_how_soon_a_refinement_stopped) {
    const auto scene = accel();
    FramePipeline pipeline;
    FrameRequest slow = request(scene, 1500, true);
    slow.isa = Isa::scalar;
    slow.threads = 1;
    FrameRequest quick = request(scene, 16);
    quick.isa = slow.isa;
    quick.threads = slow.threads;
    pipeline.submit(quick);
    EXPECT_FALSE(next(pipeline)->stop_s) << "there was no refinement";
    for (int tries = 0; tries < 100; ++tries) { // until the thread got that far
        pipeline.submit(slow);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        pipeline.submit(quick);
        const Frame *frame = next(pipeline);
        while (frame->request.refines) frame = next(pipeline);
        if (!frame->stop_s) continue;
        EXPECT_GE(*frame->stop_s, 0.0);
        return;
    }
    FAIL() << "no refinement was stopped";
}

TEST(FramePipeline, answers_an_input_once) {
    const auto scene = accel();
    FramePipeline pipeline;
    FrameRequest asked = request(scene, 32, true);
    asked.input_time = Clock::now();
    pipeline.submit(asked);
    EXPECT_TRUE(next(pipeline)->request.input_time);
    EXPECT_FALSE(next(pipeline)->request.input_time);
}

TEST(FramePipeline, says_what_failed_and_goes_on) {
    const auto scene = accel();
    FramePipeline pipeline;
    FrameRequest bad = request(scene, 32);
    bad.how.samples_per_pixel = 0;
    pipeline.submit(bad);
    const Result<const Frame *> failed = pipeline.take(Clock::now() + long_enough);
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().code, ErrorCode::bad_input);
    pipeline.submit(request(scene, 32));
    EXPECT_NE(next(pipeline), nullptr);
}

TEST(FramePipeline, takes_another_number_of_threads_and_instruction_set) {
    const auto scene = accel();
    FramePipeline pipeline;
    std::optional<uint64_t> hash;
    for (const Isa isa : available_isas()) {
        for (const unsigned threads : {1u, 3u}) {
            FrameRequest asked = request(scene, 48);
            asked.isa = isa;
            asked.threads = threads;
            pipeline.submit(asked);
            const Frame *frame = next(pipeline);
            if (!hash) hash = frame->picture->pixel_hash();
            EXPECT_EQ(frame->picture->pixel_hash(), *hash);
        }
    }
}

TEST(FramePipeline, ends_in_the_middle_of_anything) {
    const auto scene = accel();
    for (int round = 0; round < 20; ++round) {
        FramePipeline pipeline;
        pipeline.submit(request(scene, 256, round % 2 == 0));
        if (round % 3 == 0) pipeline.submit(request(scene, 128));
    }
}

} // namespace
} // namespace glint::viewer
