// A surface without an EGL surface: a context that draws into its own texture.
#include <glint/egl/surface.hpp>

#include "egl/context.hpp"
#include "gles/offscreen_surface.hpp"

namespace glint::egl {

Result<std::unique_ptr<gles::Surface>> create_surfaceless(uint32_t width_px, uint32_t height_px) {
    Result<Egl> egl = Egl::load();
    if (!egl) return std::move(egl).error();
    Result<Context> context = Context::create(*egl);
    if (!context) return std::move(context).error();
    if (!context->has_surfaceless()) {
        return Error(ErrorCode::unsupported, "the EGL display has no EGL_KHR_surfaceless_context",
                     "an EGL pbuffer serves the same purpose");
    }
    return gles::OffscreenSurface<Context>::create("egl-surfaceless", std::move(context).value(), width_px, height_px);
}

} // namespace glint::egl
