// Off-screen OpenGL in software through OSMesa, where it is installed.
#pragma once

#include <cstdint>
#include <memory>

#include <glint/export.hpp>
#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

namespace glint::osmesa {

/// A core-profile context (which takes OpenGL ES shaders unchanged) that draws into a texture of its own. libOSMesa is
/// looked up at run time: fails with `unsupported`, naming the package, where it is missing. Mesa 25.1 and later come
/// without it; glint::egl::create_surfaceless takes its place.
[[nodiscard]] GLINT_API Result<std::unique_ptr<gles::Surface>> create(uint32_t width_px, uint32_t height_px);

} // namespace glint::osmesa
