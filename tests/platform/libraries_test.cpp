// A missing library is an error that says what to install; a wrong one is found out.
#include <array>

#include <gtest/gtest.h>

#include "egl/library.hpp"
#include "osmesa/library.hpp"

namespace glint::test {
namespace {

constexpr std::array<const char *, 2> nowhere = {"libglint-no-such.so.1", "libglint-no-such.so"};
constexpr std::array<const char *, 2> second_exists = {"libglint-no-such.so.1", "libm.so.6"};

TEST(libraries, a_missing_one_is_named_with_the_package_to_install) {
    Result<egl::Egl> egl = egl::Egl::load({nowhere, egl::Egl::default_names().install_hint});
    ASSERT_FALSE(egl);
    EXPECT_EQ(egl.error().code, ErrorCode::unsupported);
    EXPECT_NE(egl.error().text().find("libglint-no-such.so.1"), std::string::npos) << egl.error().text();
    EXPECT_NE(egl.error().text().find("libegl1"), std::string::npos) << egl.error().text();

    Result<osmesa::OsMesa> mesa = osmesa::OsMesa::load({nowhere, osmesa::OsMesa::default_names().install_hint});
    ASSERT_FALSE(mesa);
    EXPECT_EQ(mesa.error().code, ErrorCode::unsupported);
    EXPECT_NE(mesa.error().text().find("libosmesa6"), std::string::npos) << mesa.error().text();
}

TEST(libraries, one_that_is_another_is_found_out_by_its_functions) {
    Result<egl::Egl> egl = egl::Egl::load({second_exists, ""});
    ASSERT_FALSE(egl);
    EXPECT_EQ(egl.error().text(), "error: libm.so.6 has no function eglBindAPI");

    Result<osmesa::OsMesa> mesa = osmesa::OsMesa::load({second_exists, ""});
    ASSERT_FALSE(mesa);
    EXPECT_EQ(mesa.error().text(), "error: libm.so.6 has no function OSMesaCreateContextAttribs");
}

TEST(libraries, egl_errors_have_their_names) {
    EXPECT_EQ(egl::error_name(EGL_SUCCESS), "EGL_SUCCESS");
    EXPECT_EQ(egl::error_name(EGL_BAD_ALLOC), "EGL_BAD_ALLOC");
    EXPECT_EQ(egl::error_name(EGL_BAD_MATCH), "EGL_BAD_MATCH");
    EXPECT_EQ(egl::error_name(EGL_CONTEXT_LOST), "EGL_CONTEXT_LOST");
    EXPECT_EQ(egl::error_name(0x1234), "error 0x1234");
}

} // namespace
} // namespace glint::test
