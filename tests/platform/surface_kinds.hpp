// The kinds of surfaces, and a test fixture that meets each.
#pragma once

#include <memory>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include <glint/gles/surface.hpp>

namespace glint::test {

struct SurfaceKind {
    const char *name; ///< of the tests; letters and underscores only
    const char *kind; ///< as Surface::kind() says it
    Result<std::unique_ptr<gles::Surface>> (*create)(uint32_t width_px, uint32_t height_px);
    /// Whether this machine has what the kind needs; if not, why, and what to install.
    Status (*look_for)();
};

std::ostream &operator<<(std::ostream &out, const SurfaceKind &kind);

[[nodiscard]] const std::vector<SurfaceKind> &surface_kinds();

/// Skips its tests where the kind is missing; otherwise has a surface of 64 x 48 pixels, which is current.
class OnEverySurface : public testing::TestWithParam<SurfaceKind> {
protected:
    void SetUp() override;
    std::unique_ptr<gles::Surface> surface_;
};

} // namespace glint::test

/// Runs the tests of a fixture derived from OnEverySurface on every kind.
#define GLINT_ON_EVERY_SURFACE(fixture)                                                                                \
    INSTANTIATE_TEST_SUITE_P(surfaces, fixture, testing::ValuesIn(glint::test::surface_kinds()),                       \
                             [](const auto &test) { return std::string(test.param.name); })
