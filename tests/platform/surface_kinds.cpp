// Which kinds of surfaces there are, and whether this machine has them.
#include "platform/surface_kinds.hpp"

#include <glint/egl/surface.hpp>
#include <glint/osmesa/surface.hpp>

#include "egl/context.hpp"
#include "osmesa/library.hpp"

namespace glint::test {

namespace {

Status look_for_egl() {
    Result<egl::Egl> library = egl::Egl::load();
    if (!library) return std::move(library).error();
    // A library without a driver is no EGL either. Other failures are for the tests to find.
    Result<egl::Context> context = egl::Context::create(*library);
    if (context || context.error().text().find("no EGL display") == std::string::npos) return Done{};
    return std::move(context).error();
}

Status look_for_osmesa() {
    Result<osmesa::OsMesa> library = osmesa::OsMesa::load();
    if (!library) return std::move(library).error();
    return Done{};
}

} // namespace

std::ostream &operator<<(std::ostream &out, const SurfaceKind &kind) {
    return out << kind.kind;
}

const std::vector<SurfaceKind> &surface_kinds() {
    static const std::vector<SurfaceKind> kinds = {
        {"egl_surfaceless", "egl-surfaceless", egl::create_surfaceless, look_for_egl},
        {"egl_pbuffer", "egl-pbuffer", egl::create_pbuffer, look_for_egl},
        {"osmesa", "osmesa", osmesa::create, look_for_osmesa},
    };
    return kinds;
}

void OnEverySurface::SetUp() {
    if (Status status = GetParam().look_for(); !status) {
        GTEST_SKIP() << "no " << GetParam().kind << " on this machine: " << status.error().text();
    }
    Result<std::unique_ptr<gles::Surface>> surface = GetParam().create(64, 48);
    ASSERT_TRUE(surface) << surface.error().text();
    surface_ = std::move(surface).value();
}

} // namespace glint::test
