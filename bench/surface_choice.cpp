// Opening the surface that pictures are shown on while they are timed.
#include "bench/surface_choice.hpp"

#include <utility>

#include <glint/egl/surface.hpp>
#include <glint/osmesa/surface.hpp>

namespace glint::bench {

Result<OpenedSurface> open_surface(SurfaceKind wanted, uint32_t width_px, uint32_t height_px) {
    OpenedSurface opened;
    if (wanted == SurfaceKind::none) return opened;

    if (wanted == SurfaceKind::egl) {
        // The pbuffer first: drivers have fast paths for window-system surfaces that a framebuffer object lacks.
        auto pbuffer = egl::create_pbuffer(width_px, height_px);
        if (pbuffer) {
            opened.surface = std::move(*pbuffer);
            return opened;
        }
        auto surfaceless = egl::create_surfaceless(width_px, height_px);
        if (surfaceless) {
            opened.surface = std::move(*surfaceless);
            return opened;
        }
        opened.notes.push_back("no EGL surface, trying OSMesa: " + surfaceless.error().text());
    }
    auto off_screen = osmesa::create(width_px, height_px);
    if (off_screen) {
        opened.surface = std::move(*off_screen);
        return opened;
    }
    if (wanted == SurfaceKind::osmesa) return off_screen.error();
    opened.notes.push_back("no OSMesa either, timing without a surface: " + off_screen.error().text());
    return opened;
}

} // namespace glint::bench
