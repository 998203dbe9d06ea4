// The presenter leaves a context's state as it found it, and is not misled by what it finds.
#include <gtest/gtest.h>

#include <glint/gles/presenter.hpp>

#include "platform/gl_snapshot.hpp"
#include "platform/picture.hpp"
#include "platform/substitutes.hpp"
#include "platform/surface_kinds.hpp"

namespace glint::test {
namespace {

class GlState : public OnEverySurface {
protected:
    /// Makes the context unusual, presents two pictures through `load`, and compares after every step.
    void present_on_an_unusual_context(const gles::ProcLoader &load) {
        Result<gles::Gl> gl = gles::Gl::load(load);
        ASSERT_TRUE(gl) << gl.error().text();
        const GlSnapshot usual = take_snapshot(*gl);
        make_unusual(*gl, load);
        ASSERT_EQ(gl->get_error(), static_cast<GLenum>(GL_NO_ERROR)) << "the test itself must not err";
        const GlSnapshot before = take_snapshot(*gl);
        EXPECT_NE(before, usual);

        Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(load);
        ASSERT_TRUE(presenter) << presenter.error().text();
        EXPECT_EQ(take_snapshot(*gl), before) << "after create()";
        for (uint32_t seed = 1; seed <= 2; ++seed) {
            const Framebuffer picture = random_picture(64, 48, seed);
            ASSERT_TRUE((*presenter)->upload(picture));
            EXPECT_EQ(take_snapshot(*gl), before) << "after upload()";
            ASSERT_TRUE((*presenter)->draw(0, 0, 64, 48));
            EXPECT_EQ(take_snapshot(*gl), before) << "after draw()";
            Result<std::vector<uint8_t>> shown = surface_->read_back();
            ASSERT_TRUE(shown) << shown.error().text();
            EXPECT_EQ(take_snapshot(*gl), before) << "after read_back()";
            EXPECT_TRUE(same_bytes(picture, *shown));
        }
        for (const gles::Filter filter : {gles::Filter::nearest, gles::Filter::bilinear, gles::Filter::sharp}) {
            for (const gles::Blend blend : {gles::Blend::replace, gles::Blend::straight, gles::Blend::premultiplied}) {
                ASSERT_TRUE((*presenter)->draw(1, 1, 5, 5, {filter, blend}));
                EXPECT_EQ(take_snapshot(*gl), before) << "after a reduced draw()";
                ASSERT_TRUE((*presenter)->draw(-5, 1, 100, 100, {filter, blend}));
                EXPECT_EQ(take_snapshot(*gl), before) << "after an enlarged draw()";
            }
        }
        presenter->reset();
        EXPECT_EQ(take_snapshot(*gl), before) << "after the presenter's end";
    }
};

GLINT_ON_EVERY_SURFACE(GlState);

TEST_P(GlState, is_the_same_before_and_after) {
    present_on_an_unusual_context(surface_->proc_loader());
}

TEST_P(GlState, is_the_same_before_and_after_on_es2) {
    if (GetParam().name == std::string("osmesa")) GTEST_SKIP() << "a core profile is never without vertex arrays";
    present_on_an_unusual_context(as_es2(surface_->proc_loader()));
}

TEST_P(GlState, survives_calls_that_fail) {
    Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(surface_->proc_loader());
    ASSERT_TRUE(presenter);
    Result<gles::Gl> gl = gles::Gl::load(surface_->proc_loader());
    ASSERT_TRUE(gl);
    make_unusual(*gl, surface_->proc_loader());
    const GlSnapshot before = take_snapshot(*gl);
    const Framebuffer picture = random_picture(64, 48, 1);
    EXPECT_FALSE((*presenter)->upload({picture.rgba8(), 64, 48, 4 * 63}));
    EXPECT_EQ(take_snapshot(*gl), before);
    EXPECT_FALSE((*presenter)->draw(0, 0, 64, 48));
    EXPECT_EQ(take_snapshot(*gl), before);
}

TEST_P(GlState, of_a_resized_surface_is_the_same_but_for_its_framebuffer) {
    Result<gles::Gl> gl = gles::Gl::load(surface_->proc_loader());
    ASSERT_TRUE(gl);
    make_unusual(*gl, surface_->proc_loader());
    GlSnapshot before = take_snapshot(*gl);
    ASSERT_TRUE(surface_->resize(33, 22));
    GlSnapshot after = take_snapshot(*gl);
    before.erase("GL_FRAMEBUFFER_BINDING");
    after.erase("GL_FRAMEBUFFER_BINDING");
    EXPECT_EQ(after, before);
}

} // namespace
} // namespace glint::test
