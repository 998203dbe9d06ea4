// What the presenter says when something is wrong, and what it leaves behind when it goes.
#include <gtest/gtest.h>

#include <glint/gles/presenter.hpp>

#include "gles/program.hpp"
#include "platform/picture.hpp"
#include "platform/substitutes.hpp"
#include "platform/surface_kinds.hpp"

namespace glint::test {
namespace {

class PresenterFaults : public OnEverySurface {
protected:
    /// A presenter that must be there.
    [[nodiscard]] std::unique_ptr<gles::Presenter> create(const gles::ProcLoader &load) const {
        Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(load);
        if (!presenter) throw std::runtime_error(presenter.error().text());
        return std::move(presenter).value();
    }
    [[nodiscard]] std::unique_ptr<gles::Presenter> create() const { return create(surface_->proc_loader()); }
};

GLINT_ON_EVERY_SURFACE(PresenterFaults);

TEST_P(PresenterFaults, without_a_current_context_there_is_no_presenter) {
    const gles::ProcLoader load = surface_->proc_loader();
    surface_.reset();
    Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(load);
    ASSERT_FALSE(presenter);
    EXPECT_EQ(presenter.error().code, ErrorCode::unsupported);
    EXPECT_EQ(presenter.error().text(), "error: no OpenGL ES context is current in this thread");
}

TEST_P(PresenterFaults, missing_functions_are_named) {
    const gles::ProcLoader load =
        with_substitutes(surface_->proc_loader(), {{"glUseProgram", nullptr}, {"glTexSubImage2D", nullptr}});
    Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(load);
    ASSERT_FALSE(presenter);
    EXPECT_EQ(presenter.error().text(), "error: the OpenGL context has no glTexSubImage2D, glUseProgram");
}

const GLubyte *es1_get_string(GLenum) {
    return reinterpret_cast<const GLubyte *>("OpenGL ES-CM 1.1");
}

TEST_P(PresenterFaults, a_context_too_old_is_refused) {
    const gles::ProcLoader load = with_substitutes(surface_->proc_loader(), {{"glGetString", as_proc(es1_get_string)}});
    Result<std::unique_ptr<gles::Presenter>> presenter = gles::Presenter::create(load);
    ASSERT_FALSE(presenter);
    EXPECT_EQ(presenter.error().text(),
              "error: the OpenGL context is 'OpenGL ES-CM 1.1', expected OpenGL ES 2.0 or newer");
}

TEST_P(PresenterFaults, pixels_that_are_none_are_refused) {
    const std::unique_ptr<gles::Presenter> presenter = create();
    const Framebuffer picture = random_picture(64, 48, 1);
    for (const gles::PixelView &view :
         {gles::PixelView(), gles::PixelView(nullptr, 64, 48, 256), gles::PixelView(picture.rgba8(), 0, 48, 256),
          gles::PixelView(picture.rgba8(), 64, 0, 256), gles::PixelView(picture.rgba8(), 64, 48, 255)}) {
        Status status = presenter->upload(view);
        ASSERT_FALSE(status);
        EXPECT_EQ(status.error().code, ErrorCode::bad_input);
        EXPECT_NE(status.error().text().find("expected at least 1 x 1"), std::string::npos) << status.error().text();
    }
    EXPECT_TRUE(shows(*surface_, *presenter, picture)) << "good pictures are welcome afterwards";
}

TEST_P(PresenterFaults, drawing_needs_an_upload) {
    const std::unique_ptr<gles::Presenter> presenter = create();
    Status status = presenter->draw(0, 0, 64, 48);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::bad_input);
    EXPECT_NE(status.error().text().find("upload()"), std::string::npos) << status.error().text();
}

TEST_P(PresenterFaults, rectangles_must_have_a_possible_size) {
    const std::unique_ptr<gles::Presenter> presenter = create();
    ASSERT_TRUE(presenter->upload(random_picture(64, 48, 1)));
    Status negative = presenter->draw(0, 0, -1, 48);
    ASSERT_FALSE(negative);
    EXPECT_EQ(negative.error().code, ErrorCode::bad_input);
    Status huge = presenter->draw(0, 0, 1 << 30, 48);
    ASSERT_FALSE(huge);
    EXPECT_EQ(huge.error().code, ErrorCode::limit_exceeded);
}

TEST_P(PresenterFaults, an_error_left_by_others_is_reported_once) {
    const std::unique_ptr<gles::Presenter> presenter = create();
    Result<gles::Gl> gl = gles::Gl::load(surface_->proc_loader());
    ASSERT_TRUE(gl);
    gl->enable(0xffff);
    Status status = presenter->upload(random_picture(64, 48, 1));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().text(), "error: GL_INVALID_ENUM was left by an OpenGL call made before");
    EXPECT_TRUE(shows(*surface_, *presenter, random_picture(64, 48, 1)));
}

PFNGLDRAWARRAYSPROC real_draw_arrays = nullptr;
void draw_wrong_primitives(GLenum, GLint first, GLsizei count) {
    real_draw_arrays(0xffff, first, count);
}

TEST_P(PresenterFaults, an_error_names_the_call_and_its_code) {
    const gles::ProcLoader load = surface_->proc_loader();
    real_draw_arrays = reinterpret_cast<PFNGLDRAWARRAYSPROC>(load("glDrawArrays"));
    const std::unique_ptr<gles::Presenter> presenter =
        create(with_substitutes(load, {{"glDrawArrays", as_proc(draw_wrong_primitives)}}));
    ASSERT_TRUE(presenter->upload(random_picture(64, 48, 1)));
    Status status = presenter->draw(0, 0, 64, 48);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().text(), "error: glDrawArrays failed with GL_INVALID_ENUM");
}

int deletions = 0;
void count_deletion(GLsizei, const GLuint *) {
    ++deletions;
}
void count_program_deletion(GLuint) {
    ++deletions;
}

TEST_P(PresenterFaults, an_abandoned_presenter_calls_opengl_no_more) {
    const gles::ProcLoader load =
        with_substitutes(surface_->proc_loader(), {{"glDeleteBuffers", as_proc(count_deletion)},
                                                   {"glDeleteTextures", as_proc(count_deletion)},
                                                   {"glDeleteVertexArrays", as_proc(count_deletion)},
                                                   {"glDeleteProgram", as_proc(count_program_deletion)}});
    std::unique_ptr<gles::Presenter> presenter = create(load);
    ASSERT_TRUE(presenter->upload(random_picture(64, 48, 1)));
    ASSERT_TRUE(presenter->draw(0, 0, 80, 80, {.filter = gles::Filter::sharp}));
    deletions = 0;
    presenter.reset();
    EXPECT_EQ(deletions, 5)
        << "without abandon() all objects are deleted: two programs, texture, vertices, their array";

    deletions = 0;
    presenter = create(load);
    ASSERT_TRUE(presenter->upload(random_picture(64, 48, 1)));
    surface_.reset();
    presenter->abandon();
    EXPECT_FALSE(presenter->upload(random_picture(64, 48, 1)));
    Status status = presenter->draw(0, 0, 64, 48);
    ASSERT_FALSE(status);
    EXPECT_NE(status.error().text().find("expected a new presenter"), std::string::npos) << status.error().text();
    presenter.reset();
    EXPECT_EQ(deletions, 0);
}

TEST_P(PresenterFaults, a_shader_that_does_not_compile_is_reported_with_the_log) {
    Result<gles::Gl> gl = gles::Gl::load(surface_->proc_loader());
    ASSERT_TRUE(gl);
    constexpr const char *good = "#version 100\nvoid main() { gl_Position = vec4(0.0); }\n";
    constexpr const char *bad = "#version 100\nvoid main() { gl_FragColor = nowhere; }\n";
    Result<GLuint> program = gles::link_program(*gl, good, bad, "corner");
    ASSERT_FALSE(program);
    EXPECT_NE(program.error().text().find("nowhere"), std::string::npos) << program.error().text();
    EXPECT_EQ(gl->get_error(), static_cast<GLenum>(GL_NO_ERROR));
}

} // namespace
} // namespace glint::test
