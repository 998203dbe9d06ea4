// What the current context is and can do.
#pragma once

#include <cstdint>
#include <string>

#include <glint/export.hpp>
#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

namespace glint::gles {

/// What a context says of itself.
struct ContextFacts {
    std::string version;                ///< GL_VERSION
    std::string vendor;                 ///< GL_VENDOR
    std::string renderer;               ///< GL_RENDERER
    uint32_t max_texture_px = 0;        ///< largest side of a texture; larger pictures are shown in parts
    uint32_t max_viewport_width_px = 0; ///< of what can be drawn on
    uint32_t max_viewport_height_px = 0;
    bool takes_bgra = false; ///< textures of B, G, R, A bytes
    bool tells_loss = false; ///< says when it is lost
};

/// Asks the context that is current. Fails as Presenter::create() does.
[[nodiscard]] GLINT_API Result<ContextFacts> describe_context(const ProcLoader &load);

} // namespace glint::gles
