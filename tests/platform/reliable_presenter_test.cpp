// Whatever becomes of contexts and surfaces, the next frame shows the picture, and nothing is left behind.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>

#include <unistd.h>

#include <gtest/gtest.h>

#include <glint/gles/reliable_presenter.hpp>

#include "platform/picture.hpp"
#include "platform/substitutes.hpp"
#include "platform/surface_kinds.hpp"

namespace glint::test {
namespace {

// OpenGL's functions know no user data; tests run one after another in one thread.
int resets_to_report = 0;
GLenum reset_status() {
    if (resets_to_report == 0) return GL_NO_ERROR;
    --resets_to_report; // drivers say it once
    return GL_GUILTY_CONTEXT_RESET_EXT;
}

GLenum pending_error = GL_NO_ERROR;
PFNGLGETERRORPROC real_get_error = nullptr;
GLenum get_error() {
    if (pending_error == GL_NO_ERROR) return real_get_error();
    return std::exchange(pending_error, static_cast<GLenum>(GL_NO_ERROR));
}

const GLubyte *say_nothing(GLenum) {
    return nullptr;
}

/// A window's stand-in: gives the presenter a context, and can lose it.
struct Window {
    const SurfaceKind &kind;
    uint32_t width_px = 64;
    uint32_t height_px = 48;
    std::unique_ptr<gles::Surface> surface = nullptr;
    int contexts_made = 0;
    bool broken = false; ///< there is no context to be had
    bool mute = false;   ///< the first context answers nothing

    Result<gles::ProcLoader> context(bool lost) {
        if (broken) return Error(ErrorCode::unsupported, "the test has no context");
        if (lost) surface.reset();
        if (surface == nullptr && contexts_made > 0 && !lost) {
            return Error(ErrorCode::unsupported, "eglMakeCurrent failed with EGL_BAD_CONTEXT");
        }
        if (surface == nullptr) {
            Result<std::unique_ptr<gles::Surface>> made = kind.create(width_px, height_px);
            if (!made) return std::move(made).error();
            surface = std::move(made).value();
            ++contexts_made;
            if (contexts_made > 1) mute = false;
        }
        if (Status status = surface->make_current(); !status) return std::move(status).error();
        if (mute) return with_substitutes(surface->proc_loader(), {{"glGetString", as_proc(say_nothing)}});
        real_get_error = reinterpret_cast<PFNGLGETERRORPROC>(surface->proc_loader()("glGetError"));
        return with_substitutes(surface->proc_loader(), {{"glGetGraphicsResetStatus", as_proc(reset_status)},
                                                         {"glGetGraphicsResetStatusKHR", as_proc(reset_status)},
                                                         {"glGetGraphicsResetStatusEXT", as_proc(reset_status)},
                                                         {"glGetError", as_proc(get_error)}});
    }
};

class ReliablePresenterTest : public OnEverySurface {
protected:
    void SetUp() override {
        OnEverySurface::SetUp();
        resets_to_report = 0;
        pending_error = GL_NO_ERROR;
        window_.emplace(GetParam());
        presenter_.emplace([this](bool lost) { return window_->context(lost); });
    }
    void TearDown() override {
        presenter_.reset();
        window_.reset();
    }

    /// The picture over the whole window.
    [[nodiscard]] static gles::Layer layer(const Framebuffer &picture, uint64_t version = 0) {
        gles::Layer all;
        all.picture = picture;
        all.width_px = static_cast<int>(picture.width_px());
        all.height_px = static_cast<int>(picture.height_px());
        all.version = version;
        return all;
    }

    [[nodiscard]] testing::AssertionResult shows_layers(const Framebuffer &expected,
                                                        std::span<const gles::Layer> layers) {
        Result<gles::ShowTimes> times = presenter_->show(layers);
        if (!times) return testing::AssertionFailure() << times.error().text();
        Result<std::vector<uint8_t>> shown = window_->surface->read_back();
        if (!shown) return testing::AssertionFailure() << shown.error().text();
        return same_bytes(expected, *shown);
    }
    [[nodiscard]] testing::AssertionResult shows_picture(const Framebuffer &picture, uint64_t version = 0) {
        const gles::Layer all = layer(picture, version);
        return shows_layers(picture, {&all, 1});
    }

    std::optional<Window> window_;
    std::optional<gles::ReliablePresenter> presenter_;
};

GLINT_ON_EVERY_SURFACE(ReliablePresenterTest);

TEST_P(ReliablePresenterTest, shows_pictures_as_long_as_nothing_happens) {
    for (uint32_t seed = 1; seed < 5; ++seed) EXPECT_TRUE(shows_picture(random_picture(64, 48, seed)));
    EXPECT_EQ(presenter_->losses(), 0u);
    EXPECT_EQ(window_->contexts_made, 1);
}

TEST_P(ReliablePresenterTest, brings_the_picture_back_when_the_context_is_destroyed_under_it) {
    const Framebuffer picture = random_picture(64, 48, 1);
    ASSERT_TRUE(shows_picture(picture, 7));
    window_->surface.reset();
    EXPECT_TRUE(shows_picture(picture, 7)) << "an unchanged version must be uploaded to the new context";
    EXPECT_EQ(presenter_->losses(), 1u);
    EXPECT_EQ(window_->contexts_made, 2);
}

TEST_P(ReliablePresenterTest, brings_the_picture_back_when_the_driver_reports_a_reset) {
    const Framebuffer picture = random_picture(64, 48, 1);
    ASSERT_TRUE(shows_picture(picture));
    resets_to_report = 1;
    EXPECT_TRUE(shows_picture(picture));
    EXPECT_EQ(presenter_->losses(), 1u);
    EXPECT_EQ(window_->contexts_made, 2);
}

TEST_P(ReliablePresenterTest, brings_the_picture_back_when_a_call_fails_with_context_lost) {
    const Framebuffer picture = random_picture(64, 48, 1);
    ASSERT_TRUE(shows_picture(picture));
    pending_error = GL_CONTEXT_LOST_KHR;
    EXPECT_TRUE(shows_picture(picture));
    EXPECT_EQ(presenter_->losses(), 1u);
}

TEST_P(ReliablePresenterTest, believes_whoever_saw_the_context_go) {
    const Framebuffer picture = random_picture(64, 48, 1);
    presenter_->context_was_lost();
    ASSERT_TRUE(shows_picture(picture));
    presenter_->context_was_lost();
    presenter_->context_was_lost();
    EXPECT_TRUE(shows_picture(picture));
    EXPECT_EQ(presenter_->losses(), 2u) << "one is none until the next show()";
}

TEST_P(ReliablePresenterTest, gives_up_after_two_losses_in_one_frame_and_begins_anew_in_the_next) {
    const Framebuffer picture = random_picture(64, 48, 1);
    ASSERT_TRUE(shows_picture(picture));
    resets_to_report = 2;
    const gles::Layer all = layer(picture);
    Result<gles::ShowTimes> times = presenter_->show({&all, 1});
    ASSERT_FALSE(times);
    EXPECT_NE(times.error().text().find("lost twice"), std::string::npos) << times.error().text();
    EXPECT_TRUE(shows_picture(picture));
    EXPECT_EQ(presenter_->losses(), 2u);
}

TEST_P(ReliablePresenterTest, reports_why_there_is_no_new_context_and_recovers_when_there_is_one) {
    const Framebuffer picture = random_picture(64, 48, 1);
    ASSERT_TRUE(shows_picture(picture));
    window_->surface.reset();
    window_->broken = true;
    const gles::Layer all = layer(picture);
    for (int frame = 0; frame < 3; ++frame) {
        Result<gles::ShowTimes> times = presenter_->show({&all, 1});
        ASSERT_FALSE(times);
        EXPECT_EQ(times.error().text(), "error: the test has no context");
    }
    window_->broken = false;
    EXPECT_TRUE(shows_picture(picture));
    EXPECT_EQ(presenter_->losses(), 1u);
}

TEST_P(ReliablePresenterTest, asks_for_another_context_where_the_first_is_of_no_use) {
    window_->mute = true;
    const Framebuffer picture = random_picture(64, 48, 1);
    const gles::Layer all = layer(picture);
    EXPECT_FALSE(presenter_->show({&all, 1}));
    EXPECT_TRUE(shows_picture(picture));
    EXPECT_EQ(window_->contexts_made, 2);
}

TEST_P(ReliablePresenterTest, takes_faults_of_the_caller_for_no_loss) {
    ASSERT_TRUE(shows_picture(random_picture(64, 48, 1)));
    gles::Layer nothing;
    nothing.width_px = nothing.height_px = 5;
    EXPECT_EQ(presenter_->show({&nothing, 1}).error().code, ErrorCode::bad_input);
    EXPECT_TRUE(shows_picture(random_picture(64, 48, 2)));
    EXPECT_EQ(presenter_->losses(), 0u);
}

TEST_P(ReliablePresenterTest, uploads_a_version_once) {
    const Framebuffer first = random_picture(64, 48, 1);
    const Framebuffer second = random_picture(64, 48, 2);
    ASSERT_TRUE(shows_picture(first, 1));
    const gles::Layer same_version = layer(second, 1);
    EXPECT_TRUE(shows_layers(first, {&same_version, 1}));
    EXPECT_TRUE(shows_picture(second, 2));
    EXPECT_TRUE(shows_picture(first, 0));
    EXPECT_TRUE(shows_picture(second, 0));
}

TEST_P(ReliablePresenterTest, draws_layers_one_over_the_other) {
    const Framebuffer below = random_picture(64, 48, 1);
    const Framebuffer above = random_picture(10, 5, 2);
    Framebuffer expected = random_picture(64, 48, 1);
    for (size_t row = 0; row < 5; ++row) {
        std::copy_n(above.rgba8() + row * 40, 40, expected.rgba8() + ((48 - 3 - 5 + row) * 64 + 2) * 4);
    }
    std::array layers = {layer(below), layer(above)};
    layers[1].x = 2;
    layers[1].y = 3;
    EXPECT_TRUE(shows_layers(expected, layers));
    window_->surface.reset();
    EXPECT_TRUE(shows_layers(expected, layers));
    EXPECT_TRUE(shows_picture(below)) << "fewer layers than before";
}

TEST_P(ReliablePresenterTest, measures_what_it_does) {
    const Framebuffer picture = random_picture(64, 48, 1);
    const gles::Layer all = layer(picture);
    const Result<gles::ShowTimes> times = presenter_->show({&all, 1}, {.finish = true});
    ASSERT_TRUE(times);
    EXPECT_GT(times->upload_s, 0.0);
    EXPECT_GT(times->draw_s, 0.0);
}

TEST_P(ReliablePresenterTest, outlives_its_window) {
    ASSERT_TRUE(shows_picture(random_picture(64, 48, 1)));
    window_->surface.reset();
    presenter_.reset(); // nothing can be deleted, and nothing may be tried
}

/// Megabytes of this process in memory; nothing where the system does not say.
std::optional<double> resident_mb() {
    std::ifstream statm("/proc/self/statm");
    long pages = 0, resident = 0;
    if (!(statm >> pages >> resident)) return std::nullopt;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

// Sanitizers keep freed memory on purpose.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool memory_means_something = false;
constexpr int many_losses = 120; // drivers take seconds for more
#else
constexpr bool memory_means_something = true;
constexpr int many_losses = 1000;
#endif

/// Losses of all sorts, each followed by a frame; sizes of window and picture change in between.
TEST_P(ReliablePresenterTest, survives_a_thousand_losses_without_a_leak) {
    constexpr int losses = many_losses, warm_up = 100;
    const std::array<std::pair<uint32_t, uint32_t>, 3> sizes = {{{64, 48}, {33, 57}, {128, 16}}};
    std::optional<double> warm_mb;
    for (int loss = 0; loss < losses; ++loss) {
        if (loss == warm_up) warm_mb = resident_mb();
        const auto &[width_px, height_px] = sizes[static_cast<size_t>(loss) / 5 % sizes.size()];
        window_->width_px = width_px;
        window_->height_px = height_px;
        if (window_->surface != nullptr) {
            ASSERT_TRUE(window_->surface->resize(width_px, height_px));
        }
        const Framebuffer picture = random_picture(width_px, height_px, static_cast<uint32_t>(loss));
        ASSERT_TRUE(shows_picture(picture)) << "before loss " << loss;
        switch (loss % 3) {
        case 0:
            window_->surface.reset();
            break;
        case 1:
            resets_to_report = 1;
            break;
        default:
            presenter_->context_was_lost();
        }
        ASSERT_TRUE(shows_picture(picture)) << "after loss " << loss;
        ASSERT_EQ(presenter_->losses(), static_cast<uint64_t>(loss) + 1);
    }
    if (!memory_means_something || !warm_mb) return;
    const double growth_mb = *resident_mb() - *warm_mb;
    RecordProperty("growth_kb", static_cast<int>(1000 * growth_mb));
    std::printf("resident memory %.3f MB, grew by %.3f MB in %d losses\n", *warm_mb, growth_mb, losses - warm_up);
    EXPECT_LT(growth_mb, 2.0);
}

} // namespace
} // namespace glint::test
