// Surfaces as such: sizes, contents, living together, and leaving nothing behind.
#include <filesystem>

#include <gtest/gtest.h>

#include <glint/gles/presenter.hpp>

#include "gles/gl.hpp"
#include "platform/picture.hpp"
#include "platform/surface_kinds.hpp"

namespace glint::test {
namespace {

class SurfaceTest : public OnEverySurface {};

GLINT_ON_EVERY_SURFACE(SurfaceTest);

TEST_P(SurfaceTest, says_what_it_is) {
    EXPECT_EQ(surface_->kind(), GetParam().kind);
    EXPECT_EQ(surface_->width_px(), 64u);
    EXPECT_EQ(surface_->height_px(), 48u);
    Result<gles::Gl> gl = gles::Gl::load(surface_->proc_loader());
    ASSERT_TRUE(gl);
    EXPECT_NE(surface_->gl_description().find(gl->renderer), std::string::npos) << surface_->gl_description();
    EXPECT_NE(surface_->gl_description().find(gl->version), std::string::npos) << surface_->gl_description();
}

// Without the presenter, so that two flips cannot cancel each other.
TEST_P(SurfaceTest, reads_back_the_top_row_first) {
    const gles::ProcLoader load = surface_->proc_loader();
    const auto clear_color = reinterpret_cast<PFNGLCLEARCOLORPROC>(load("glClearColor"));
    const auto clear = reinterpret_cast<PFNGLCLEARPROC>(load("glClear"));
    const auto scissor = reinterpret_cast<PFNGLSCISSORPROC>(load("glScissor"));
    Result<gles::Gl> gl = gles::Gl::load(load);
    ASSERT_TRUE(gl);
    Framebuffer expected = random_picture(64, 48, 1);
    std::fill_n(expected.rgba8(), 64 * 48 * 4, uint8_t{0});
    clear_color(0, 0, 0, 0);
    clear(GL_COLOR_BUFFER_BIT);
    // The lower left corner, in OpenGL's coordinates, is the bottom row's first pixel.
    gl->enable(GL_SCISSOR_TEST);
    scissor(0, 0, 1, 1);
    clear_color(1, 0, 0.2f, 1);
    clear(GL_COLOR_BUFFER_BIT);
    const uint8_t red[4] = {255, 0, 51, 255};
    std::copy_n(red, 4, expected.rgba8() + 47 * 64 * 4);
    Result<std::vector<uint8_t>> shown = surface_->read_back();
    ASSERT_TRUE(shown);
    EXPECT_TRUE(same_bytes(expected, *shown));
}

TEST_P(SurfaceTest, refuses_sizes_it_cannot_have_and_keeps_the_old_one) {
    Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(surface_->proc_loader());
    ASSERT_TRUE(presenter);
    for (const auto &[width_px, height_px, code] :
         {std::tuple{0u, 48u, ErrorCode::bad_input}, std::tuple{64u, 0u, ErrorCode::bad_input},
          std::tuple{200000u, 48u, ErrorCode::limit_exceeded}, std::tuple{64u, 200000u, ErrorCode::limit_exceeded},
          std::tuple{UINT32_MAX, UINT32_MAX, ErrorCode::limit_exceeded}}) {
        Status status = surface_->resize(width_px, height_px);
        ASSERT_FALSE(status);
        EXPECT_EQ(status.error().code, code) << status.error().text();
        EXPECT_EQ(surface_->width_px(), 64u);
        EXPECT_EQ(surface_->height_px(), 48u);
    }
    EXPECT_TRUE(shows(*surface_, **presenter, random_picture(64, 48, 1)));
}

TEST_P(SurfaceTest, is_not_created_in_a_size_it_cannot_have) {
    EXPECT_EQ(GetParam().create(0, 1).error().code, ErrorCode::bad_input);
    EXPECT_EQ(GetParam().create(1, 200000).error().code, ErrorCode::limit_exceeded);
}

TEST_P(SurfaceTest, binds_its_own_framebuffer_when_made_current) {
    Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(surface_->proc_loader());
    ASSERT_TRUE(presenter);
    Result<gles::Gl> gl = gles::Gl::load(surface_->proc_loader());
    ASSERT_TRUE(gl);
    GLuint foreign = 0;
    gl->gen_framebuffers(1, &foreign);
    gl->bind_framebuffer(GL_FRAMEBUFFER, foreign);
    EXPECT_FALSE(shows(*surface_, **presenter, random_picture(64, 48, 1))) << "nothing can be drawn on an empty one";
    ASSERT_TRUE(surface_->make_current());
    EXPECT_TRUE(shows(*surface_, **presenter, random_picture(64, 48, 1)));
}

TEST_P(SurfaceTest, of_every_kind_take_turns_in_one_thread) {
    struct Turn {
        std::unique_ptr<gles::Surface> surface;
        std::unique_ptr<gles::Presenter> presenter;
    };
    std::vector<Turn> turns;
    for (const SurfaceKind &kind : surface_kinds()) {
        if (!kind.look_for()) continue;
        for (int copy = 0; copy < 2; ++copy) {
            Result<std::unique_ptr<gles::Surface>> surface = kind.create(40, 30);
            ASSERT_TRUE(surface) << surface.error().text();
            Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create((*surface)->proc_loader());
            ASSERT_TRUE(presenter) << presenter.error().text();
            turns.push_back({std::move(surface).value(), std::move(presenter).value()});
        }
    }
    for (uint32_t round = 0; round < 3; ++round) {
        for (size_t i = 0; i < turns.size(); ++i) {
            ASSERT_TRUE(turns[i].surface->make_current());
            EXPECT_TRUE(shows(*turns[i].surface, *turns[i].presenter,
                              random_picture(40, 30, round * 100 + static_cast<uint32_t>(i))))
                << turns[i].surface->kind() << ", round " << round;
        }
    }
    for (Turn &turn : turns) {
        ASSERT_TRUE(turn.surface->make_current());
        turn.presenter.reset();
        turn.surface.reset();
    }
}

TEST_P(SurfaceTest, may_end_while_another_is_current) {
    Result<std::unique_ptr<gles::Surface>> other = GetParam().create(8, 8);
    ASSERT_TRUE(other);
    ASSERT_TRUE(surface_->make_current());
    other->reset();
    // No make_current() here: the end of the other must not have touched this one.
    Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(surface_->proc_loader());
    ASSERT_TRUE(presenter) << presenter.error().text();
    EXPECT_TRUE(shows(*surface_, **presenter, random_picture(64, 48, 1)));
}

/// How many of the first names are objects of OpenGL.
struct ObjectCounts {
    int textures = 0, buffers = 0, programs = 0, shaders = 0, framebuffers = 0;
    bool operator==(const ObjectCounts &) const = default;
};

ObjectCounts count_objects(const gles::ProcLoader &load) {
    const auto is_texture = reinterpret_cast<PFNGLISTEXTUREPROC>(load("glIsTexture"));
    const auto is_buffer = reinterpret_cast<PFNGLISBUFFERPROC>(load("glIsBuffer"));
    const auto is_program = reinterpret_cast<PFNGLISPROGRAMPROC>(load("glIsProgram"));
    const auto is_shader = reinterpret_cast<PFNGLISSHADERPROC>(load("glIsShader"));
    const auto is_framebuffer = reinterpret_cast<PFNGLISFRAMEBUFFERPROC>(load("glIsFramebuffer"));
    ObjectCounts counts;
    for (GLuint name = 1; name < 2000; ++name) {
        counts.textures += is_texture(name);
        counts.buffers += is_buffer(name);
        counts.programs += is_program(name);
        counts.shaders += is_shader(name);
        counts.framebuffers += is_framebuffer(name);
    }
    return counts;
}

TEST_P(SurfaceTest, is_left_without_gl_objects_by_many_presenters_and_resizes) {
    const ObjectCounts before = count_objects(surface_->proc_loader());
    for (uint32_t i = 0; i < 40; ++i) {
        Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(surface_->proc_loader());
        ASSERT_TRUE(presenter);
        ASSERT_TRUE(surface_->resize(10 + i, 20));
        ASSERT_TRUE(shows(*surface_, **presenter, random_picture(10 + i, 20, i)));
    }
    EXPECT_TRUE(count_objects(surface_->proc_loader()) == before);
}

size_t entries_of(const char *folder) {
    size_t count = 0;
    for ([[maybe_unused]] const auto &entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

TEST_P(SurfaceTest, leaves_no_file_or_thread_behind_when_it_goes) {
    if (!std::filesystem::exists("/proc/self/fd")) GTEST_SKIP() << "no /proc/self/fd to count in";
    surface_.reset();
    // The first of a kind may load drivers that stay; the fixture's was the first.
    const size_t files = entries_of("/proc/self/fd");
    const size_t threads = entries_of("/proc/self/task");
    for (int i = 0; i < 30; ++i) {
        Result<std::unique_ptr<gles::Surface>> surface = GetParam().create(32, 32);
        ASSERT_TRUE(surface) << surface.error().text();
        Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create((*surface)->proc_loader());
        ASSERT_TRUE(presenter);
        ASSERT_TRUE(shows(**surface, **presenter, random_picture(32, 32, 1)));
        presenter->reset(); // before the context it lives in
    }
    EXPECT_EQ(entries_of("/proc/self/fd"), files);
    EXPECT_EQ(entries_of("/proc/self/task"), threads);
}

} // namespace
} // namespace glint::test
