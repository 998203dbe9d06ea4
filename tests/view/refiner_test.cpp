// The picture in passes: which samples it shows, that the last is the picture of 16 samples, and that it can be
// stopped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <thread>

#include <glint/glint.hpp>

#include "support/random.hpp"
#include "view/average.hpp"

namespace glint::test {
namespace {

std::shared_ptr<const Accel> accel_of(const char *name) {
    const auto file = read_scene(std::string(GLINT_SOURCE_DIR) + "/scenes/sdl/" + name);
    if (!file) throw std::runtime_error(file.error().text());
    return Accel::build(file->scene);
}

Framebuffer framebuffer(uint32_t width, uint32_t height, bool with_radiance = true) {
    return std::move(Framebuffer::create(width, height, with_radiance)).value();
}

Framebuffer picture_of(Renderer &renderer, uint32_t width, uint32_t height, const RenderOptions &options) {
    Framebuffer picture = framebuffer(width, height);
    EXPECT_TRUE(renderer.render(picture, options).ok());
    return picture;
}

RenderOptions sixteen_samples(RenderOptions options = {}) {
    options.samples_per_pixel = 16;
    options.pattern = SamplePattern::centre;
    return options;
}

struct Difference {
    size_t bytes = 0; ///< that differ
    int greatest = 0;
};

Difference difference(const Framebuffer &a, const Framebuffer &b) {
    Difference found;
    for (size_t i = 0; i < size_t{a.width_px()} * a.height_px() * 4; ++i) {
        const int off = std::abs(a.rgba8()[i] - b.rgba8()[i]);
        found.bytes += off > 0 ? 1 : 0;
        found.greatest = std::max(found.greatest, off);
    }
    return found;
}

double squared_error(const Framebuffer &a, const Framebuffer &b) {
    double sum = 0.0;
    for (size_t i = 0; i < size_t{a.width_px()} * a.height_px() * 4; ++i) {
        const double off = double(a.rgba8()[i]) - b.rgba8()[i];
        sum += off * off;
    }
    return sum;
}

TEST(RenderOptions, one_sample_of_a_grid_is_that_sample) {
    // The average of the samples one by one is the picture of all, but for how sums round.
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 2});
    for (const SamplePattern pattern : {SamplePattern::centre, SamplePattern::stratified, SamplePattern::jittered}) {
        RenderOptions options;
        options.samples_per_pixel = 6;
        options.pattern = pattern;
        const Framebuffer all = picture_of(renderer, 70, 50, options);
        std::vector<double> sums(size_t{70} * 50 * 3, 0.0);
        size_t differing = 0;
        std::optional<Framebuffer> before;
        for (uint32_t sample = 0; sample < 6; ++sample) {
            options.only_sample = sample;
            Framebuffer one = picture_of(renderer, 70, 50, options);
            for (size_t i = 0; i < sums.size(); ++i) sums[i] += double(one.radiance()[i]) / 6.0;
            if (before) differing += one.radiance_hash() != before->radiance_hash() ? 1 : 0;
            before = std::move(one);
        }
        EXPECT_EQ(differing, 5u);
        for (size_t i = 0; i < sums.size(); ++i) ASSERT_NEAR(sums[i], double(all.radiance()[i]), 2e-6);
    }
}

TEST(RenderOptions, one_sample_has_the_same_bits_on_every_instruction_set) {
    const auto accel = accel_of("glass.sdl");
    for (const SamplePattern pattern : {SamplePattern::centre, SamplePattern::stratified}) {
        RenderOptions options;
        options.samples_per_pixel = 16;
        options.pattern = pattern;
        options.only_sample = 7;
        Renderer scalar(accel, {.threads = 2, .isa = Isa::scalar});
        const Framebuffer expected = picture_of(scalar, 53, 37, options);
        for (const Isa isa : available_isas()) {
            Renderer renderer(accel, {.threads = 1, .isa = isa});
            EXPECT_EQ(picture_of(renderer, 53, 37, options).radiance_hash(), expected.radiance_hash()) << isa_name(isa);
        }
    }
}

TEST(RenderOptions, a_sample_that_is_not_in_the_grid_is_refused) {
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 1});
    Framebuffer target = framebuffer(8, 8);
    RenderOptions options;
    options.samples_per_pixel = 4;
    options.only_sample = 4;
    const auto result = renderer.render(target, options);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::bad_input);
    EXPECT_NE(result.error().text().find("only sample 4 of 4"), std::string::npos) << result.error().text();
}

TEST(Refiner, begins_with_the_ordinary_picture_and_ends_with_that_of_16_samples) {
    for (const char *const scene : {"cornell.sdl", "glass.sdl"}) {
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
            RenderOptions options;
            options.transfer = transfer;
            Renderer renderer(accel_of(scene), {.threads = 2});
            Refiner refiner(options);
            Framebuffer target = framebuffer(90, 70);

            ASSERT_TRUE(refiner.next(renderer, target).ok());
            EXPECT_EQ(refiner.samples_done(), 0u);
            RenderOptions one = options; // the glass scene asks for more
            one.samples_per_pixel = 1;
            one.pattern = SamplePattern::centre;
            const Framebuffer ordinary = picture_of(renderer, 90, 70, one);
            EXPECT_EQ(target.pixel_hash(), ordinary.pixel_hash());
            EXPECT_EQ(target.radiance_hash(), ordinary.radiance_hash());

            unsigned passes = 1;
            for (; !refiner.done(); ++passes) {
                ASSERT_TRUE(refiner.next(renderer, target).ok());
                EXPECT_EQ(refiner.samples_done(), passes);
            }
            EXPECT_EQ(passes, 17u);
            // The kernels add up rays, the refiner samples: sums of floats, in another order. So a byte may be one off
            // where the average lies between two.
            const Framebuffer expected = picture_of(renderer, 90, 70, sixteen_samples(options));
            const Difference found = difference(target, expected);
            EXPECT_LE(found.greatest, 1);
            EXPECT_LE(found.bytes, 90u * 70u * 3u / 1000u);
            for (size_t i = 0; i < size_t{90} * 70 * 3; ++i) {
                ASSERT_NEAR(target.radiance()[i], expected.radiance()[i],
                            4e-6f * std::max(1.0f, expected.radiance()[i]));
            }
        }
    }
}

TEST(Refiner, shows_the_average_of_the_samples_it_has) {
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 2});
    Refiner refiner;
    Framebuffer target = framebuffer(60, 40);
    ASSERT_TRUE(refiner.next(renderer, target).ok());
    std::vector<Framebuffer> samples;
    for (uint32_t sample = 0; sample < 16; ++sample) {
        RenderOptions options = sixteen_samples();
        options.only_sample = sample;
        samples.push_back(picture_of(renderer, 60, 40, options));
    }
    // Which sample a pass adds is seen by what it changes: each of them once.
    std::vector<double> sums(size_t{60} * 40 * 3, 0.0);
    std::vector<bool> is_taken(16, false);
    for (uint32_t pass = 1; pass <= 16; ++pass) {
        ASSERT_TRUE(refiner.next(renderer, target).ok());
        uint32_t best = 0;
        double least = 1e30;
        for (uint32_t sample = 0; sample < 16; ++sample) {
            double error = 0.0;
            for (size_t i = 0; i < sums.size(); ++i) {
                const double added = double(target.radiance()[i]) * pass - sums[i];
                error = std::max(error, std::abs(added - double(samples[sample].radiance()[i])));
            }
            if (error < least) {
                least = error;
                best = sample;
            }
        }
        EXPECT_LT(least, 1e-4);
        EXPECT_FALSE(is_taken[best]) << "sample " << best << " twice";
        is_taken[best] = true;
        for (size_t i = 0; i < sums.size(); ++i) sums[i] += double(samples[best].radiance()[i]);
    }
}

TEST(Refiner, comes_nearer_to_the_last_picture_with_every_four_samples) {
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 2});
    const Framebuffer last = picture_of(renderer, 128, 128, sixteen_samples());
    Refiner refiner;
    Framebuffer target = framebuffer(128, 128, false);
    ASSERT_TRUE(refiner.next(renderer, target).ok());
    double before = squared_error(target, last);
    ASSERT_TRUE(refiner.next(renderer, target).ok());
    EXPECT_LT(squared_error(target, last), 1.1 * before) << "nothing is lost where the centre makes way";
    while (!refiner.done()) {
        ASSERT_TRUE(refiner.next(renderer, target).ok());
        if (refiner.samples_done() % 4 != 0) continue;
        const double error = squared_error(target, last);
        EXPECT_LT(error, 0.6 * before) << refiner.samples_done();
        before = error;
    }
}

TEST(Refiner, goes_through_the_scenes_tone_curve) {
    SceneBuilder builder;
    const auto cornell = accel_of("cornell.sdl");
    PictureSettings picture;
    picture.tone_scale = 0.5f;
    for (const Object &object : cornell->scene().objects()) builder.add_object(object);
    for (const Light &light : cornell->scene().lights()) builder.add_light(light);
    builder.set_camera(cornell->scene().camera()).set_picture(picture).set_ambient(0.3f);
    Renderer renderer(Accel::build(*builder.build()), {.threads = 2});
    Refiner refiner;
    Framebuffer target = framebuffer(40, 40);
    while (!refiner.done()) ASSERT_TRUE(refiner.next(renderer, target).ok());
    EXPECT_LE(difference(target, picture_of(renderer, 40, 40, sixteen_samples())).greatest, 1);
}

TEST(Refiner, fills_whichever_framebuffer_it_is_given) {
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 2});
    Refiner one_target, two_targets;
    Framebuffer a = framebuffer(70, 30), b = framebuffer(70, 30, false), c = framebuffer(70, 30);
    for (int pass = 0; !one_target.done(); ++pass) {
        Framebuffer &other = pass % 2 == 0 ? b : c;
        ASSERT_TRUE(one_target.next(renderer, a).ok());
        ASSERT_TRUE(two_targets.next(renderer, other).ok());
        EXPECT_EQ(a.pixel_hash(), other.pixel_hash()) << pass;
    }
    const uint64_t last = a.pixel_hash();
    std::memset(b.rgba8(), 0, size_t{70} * 30 * 4);
    ASSERT_TRUE(two_targets.next(renderer, b).ok()) << "once done it only fills the target";
    EXPECT_EQ(b.pixel_hash(), last);
    EXPECT_TRUE(two_targets.done());
}

TEST(Refiner, begins_anew_when_told_to_and_for_another_size) {
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 2});
    Refiner refiner;
    Framebuffer small = framebuffer(40, 30), large = framebuffer(90, 80);
    for (int pass = 0; pass < 4; ++pass) ASSERT_TRUE(refiner.next(renderer, small).ok());
    EXPECT_EQ(refiner.samples_done(), 3u);
    ASSERT_TRUE(refiner.next(renderer, large).ok());
    EXPECT_EQ(refiner.samples_done(), 0u);
    while (!refiner.done()) ASSERT_TRUE(refiner.next(renderer, large).ok());
    EXPECT_LE(difference(large, picture_of(renderer, 90, 80, sixteen_samples())).greatest, 1);

    RenderOptions options;
    options.camera = Camera::look_at({0.3f, 0.2f, 5}, {0, 0, 0}, {0, 1, 0}, 0.5f, 0.5f);
    refiner.restart(options);
    EXPECT_FALSE(refiner.done());
    while (!refiner.done()) ASSERT_TRUE(refiner.next(renderer, large).ok());
    EXPECT_LE(difference(large, picture_of(renderer, 90, 80, sixteen_samples(options))).greatest, 1);
}

TEST(Refiner, tells_what_is_wrong_with_the_options_and_goes_on_with_others) {
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 1});
    RenderOptions options;
    options.camera = Camera{};
    options.camera->right = Vector(0.0f);
    Refiner refiner(options);
    Framebuffer target = framebuffer(16, 16);
    const auto result = refiner.next(renderer, target);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::bad_input);
    refiner.restart({});
    EXPECT_TRUE(refiner.next(renderer, target).ok());
}

TEST(Refiner, loses_no_sample_and_takes_none_twice_when_it_is_cancelled) {
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 2});
    Framebuffer undisturbed = framebuffer(200, 160);
    Refiner refiner;
    while (!refiner.done()) ASSERT_TRUE(refiner.next(renderer, undisturbed).ok());

    Random random(21);
    unsigned cancelled = 0;
    for (int round = 0; round < 20; ++round) {
        refiner.restart({});
        Framebuffer target = framebuffer(200, 160);
        RenderControl control;
        std::atomic<bool> is_over{false};
        std::thread canceller([&] {
            while (!is_over) {
                control.cancel();
                std::this_thread::sleep_for(std::chrono::microseconds(random.below(1500)));
            }
        });
        // At most so many disturbances, so that it comes to an end on a busy machine too.
        for (int attempt = 0; !refiner.done(); ++attempt) {
            const bool may_be_disturbed = attempt < 60;
            control.reset();
            const uint32_t before = refiner.samples_done();
            const auto result = refiner.next(renderer, target, may_be_disturbed ? &control : nullptr);
            if (!result) {
                EXPECT_EQ(result.error().code, ErrorCode::cancelled);
                EXPECT_EQ(refiner.samples_done(), before);
                ++cancelled;
            }
        }
        is_over = true;
        canceller.join();
        ASSERT_TRUE(refiner.next(renderer, target).ok());
        ASSERT_EQ(target.pixel_hash(), undisturbed.pixel_hash());
        ASSERT_EQ(target.radiance_hash(), undisturbed.radiance_hash());
    }
    EXPECT_GT(cancelled, 0u);
}

TEST(Refiner, does_nothing_under_a_control_that_was_cancelled_before) {
    Renderer renderer(accel_of("cornell.sdl"), {.threads = 2});
    Refiner refiner;
    Framebuffer target = framebuffer(64, 64);
    ASSERT_TRUE(refiner.next(renderer, target).ok());
    const uint64_t before = target.pixel_hash();
    RenderControl control;
    control.cancel();
    EXPECT_EQ(refiner.next(renderer, target, &control).error().code, ErrorCode::cancelled);
    EXPECT_EQ(refiner.samples_done(), 0u);
    EXPECT_EQ(target.pixel_hash(), before);
}

TEST(Refiner, survives_any_order_of_calls) {
    Renderer first(accel_of("cornell.sdl"), {.threads = 2}), second(accel_of("glass.sdl"), {.threads = 1});
    Random random(33);
    std::vector<Framebuffer> targets;
    for (const uint32_t width : {1u, 17u, 64u}) {
        for (const uint32_t height : {1u, 33u}) targets.push_back(framebuffer(width, height, random.below(2) == 0));
    }
    Refiner refiner;
    Framebuffer *target = &targets[0];
    for (int call = 0; call < 3000; ++call) {
        RenderControl control;
        switch (random.below(12)) {
        case 0:
            target = &targets[random.below(static_cast<uint32_t>(targets.size()))];
            break;
        case 1: {
            RenderOptions options;
            options.max_depth = random.below(4);
            options.samples_per_pixel = random.below(20); // its own in any case
            options.only_sample = random.next();
            refiner.restart(options);
            break;
        }
        case 2:
            control.cancel();
            EXPECT_FALSE(refiner.next(first, *target, &control).ok());
            break;
        case 3:
            refiner = Refiner();
            break;
        case 4:
            EXPECT_TRUE(refiner.next(second, *target).ok());
            break;
        default:
            EXPECT_TRUE(refiner.next(first, *target, &control).ok());
        }
        ASSERT_LE(refiner.samples_done(), Refiner::samples);
        ASSERT_TRUE(!refiner.done() || refiner.samples_done() == Refiner::samples);
    }
}

TEST(Average, writes_the_bytes_it_should_and_none_beside_them) {
    constexpr size_t most = 700;
    std::vector<float> sums(3 * most);
    Random random(9);
    for (float &sum : sums) sum = random.uniform(-1.0f, 9.0f);
    for (const size_t pixels : {size_t{0}, size_t{1}, size_t{255}, size_t{256}, size_t{257}, most}) {
        std::vector<uint8_t> bytes(4 * most + 1, 7);
        std::vector<float> radiance(3 * most + 1, -5.0f);
        show_average(sums.data(), {0.125f, 0.0f, false}, pixels, bytes.data(), radiance.data());
        for (size_t i = 0; i < pixels; ++i) {
            for (size_t channel = 0; channel < 3; ++channel) {
                const float c = sums[3 * i + channel] * 0.125f;
                EXPECT_EQ(radiance[3 * i + channel], c);
                EXPECT_EQ(bytes[4 * i + channel], static_cast<uint8_t>(std::clamp(255.0f * c + 0.5f, 0.0f, 255.0f)));
            }
            EXPECT_EQ(bytes[4 * i + 3], 255);
        }
        EXPECT_EQ(bytes[4 * pixels], 7);
        EXPECT_EQ(radiance[3 * pixels], -5.0f);
    }
}

} // namespace
} // namespace glint::test
