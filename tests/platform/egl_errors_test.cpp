// What EGL refuses is told with the call and the name of the code.
#include <array>

#include <gtest/gtest.h>

#include <glint/egl/survey.hpp>

#include "egl/context.hpp"
#include "egl/display.hpp"

namespace glint::test {
namespace {

class EglErrors : public testing::Test {
protected:
    void SetUp() override {
        Result<egl::Egl> library = egl::Egl::load();
        if (!library) GTEST_SKIP() << library.error().text();
        egl_ = *library;
        if (!egl::Context::create(egl_)) GTEST_SKIP() << "no EGL display on this machine";
    }
    egl::Egl egl_;
};

TEST_F(EglErrors, a_display_that_is_none_is_told) {
    const Result<egl::Context> context = egl::Context::create_on(egl_, EGL_NO_DISPLAY, 3);
    ASSERT_FALSE(context);
    EXPECT_EQ(context.error().diagnostics.front().message.find("eglChooseConfig failed with EGL_BAD_DISPLAY"), 0u)
        << context.error().text();
}

TEST_F(EglErrors, a_surface_that_is_gone_is_told) {
    Result<egl::Context> context = egl::Context::create(egl_);
    ASSERT_TRUE(context);
    constexpr std::array<EGLint, 5> size = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    const EGLSurface surface = egl_.create_pbuffer_surface(context->display(), context->config(), size.data());
    ASSERT_NE(surface, EGL_NO_SURFACE);
    egl_.destroy_surface(context->display(), surface);
    const Status status = context->make_current(surface);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().text(), "error: eglMakeCurrent failed with EGL_BAD_SURFACE");
}

TEST_F(EglErrors, a_platform_that_is_unknown_is_told_by_its_extension) {
    egl_.get_platform_display = nullptr; // EGL 1.4
    const Result<EGLDisplay> display =
        egl::open_display(egl_, {"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, nullptr, ""});
    ASSERT_FALSE(display);
    EXPECT_EQ(display.error().text(), "error: EGL has no EGL_MESA_platform_surfaceless");
}

EGLBoolean EGLAPIENTRY initialize_nothing(EGLDisplay, EGLint *, EGLint *) {
    return EGL_FALSE;
}
EGLint EGLAPIENTRY not_initialized() {
    return EGL_NOT_INITIALIZED;
}

TEST_F(EglErrors, no_display_at_all_is_told_with_every_attempt) {
    egl_.initialize = initialize_nothing;
    egl_.get_error = not_initialized;
    const Result<egl::Context> context = egl::Context::create(egl_);
    ASSERT_FALSE(context);
    const std::string text = context.error().text();
    EXPECT_EQ(context.error().code, ErrorCode::unsupported);
    for (const egl::DisplayRoute &route : egl::off_screen_routes(egl_)) {
        EXPECT_NE(text.find(route.name + ": "), std::string::npos) << text;
    }
    EXPECT_NE(text.find("eglInitialize failed with EGL_NOT_INITIALIZED"), std::string::npos) << text;
    EXPECT_NE(text.find("libgl1-mesa-dri"), std::string::npos) << text;
}

PFNEGLCREATECONTEXTPROC real_create_context = nullptr;
int robust_requests = 0;
EGLContext EGLAPIENTRY create_only_plain(EGLDisplay display, EGLConfig config, EGLContext shared,
                                         const EGLint *attributes) {
    for (const EGLint *name = attributes; *name != EGL_NONE; name += 2) {
        if (*name != EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT) continue;
        ++robust_requests;
        return EGL_NO_CONTEXT;
    }
    return real_create_context(display, config, shared, attributes);
}

TEST_F(EglErrors, a_driver_that_promises_notifications_and_refuses_them_still_gives_a_context) {
    real_create_context = egl_.create_context;
    egl_.create_context = create_only_plain;
    robust_requests = 0;
    const Result<egl::Context> context = egl::Context::create(egl_);
    EXPECT_TRUE(context);
    if (egl_.has_display_extension(context->display(), "EGL_EXT_create_context_robustness")) {
        EXPECT_EQ(robust_requests, 1);
    }
}

TEST_F(EglErrors, a_survey_finds_what_surfaces_use_and_leaves_nothing_current) {
    const egl::Survey survey = egl::survey();
    EXPECT_TRUE(survey.missing.empty()) << survey.missing;
    EXPECT_TRUE(survey.has_context());
    EXPECT_EQ(egl_.get_current_context(), EGL_NO_CONTEXT);
}

} // namespace
} // namespace glint::test
