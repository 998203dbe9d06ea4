// Opening the surface that pictures are shown on while they are timed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

namespace glint::bench {

enum class SurfaceKind {
    egl,    ///< an off-screen EGL surface; OSMesa, then none, where there is no EGL
    osmesa, ///< OSMesa and nothing else
    none,   ///< pictures are rendered and not shown
};

struct OpenedSurface {
    std::unique_ptr<gles::Surface> surface; ///< nullptr for none
    std::vector<std::string> notes;         ///< what was tried in vain, for the user's eyes
};

/// Fails only where `wanted` is OSMesa and it is not there.
[[nodiscard]] Result<OpenedSurface> open_surface(SurfaceKind wanted, uint32_t width_px, uint32_t height_px);

} // namespace glint::bench
