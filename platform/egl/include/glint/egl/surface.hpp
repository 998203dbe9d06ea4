// Off-screen OpenGL ES through EGL, with or without a display server.
#pragma once

#include <cstdint>
#include <memory>

#include <glint/export.hpp>
#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

namespace glint::egl {

/// A context without any EGL surface that draws into a texture of its own. libEGL is looked up at run time: fails with
/// `unsupported`, naming what to install, where it or a driver is missing.
[[nodiscard]] GLINT_API Result<std::unique_ptr<gles::Surface>> create_surfaceless(uint32_t width_px,
                                                                                  uint32_t height_px);

/// A context that draws into an EGL pbuffer; otherwise as above.
[[nodiscard]] GLINT_API Result<std::unique_ptr<gles::Surface>> create_pbuffer(uint32_t width_px, uint32_t height_px);

} // namespace glint::egl
