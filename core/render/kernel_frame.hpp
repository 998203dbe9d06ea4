// A picture to be rendered, as the kernels see it.
#pragma once

#include <glint/renderer.hpp>

#include "kernel/kernel.hpp"

namespace glint {

/// What the options and, where they leave it open, the scene ask for; without memory to draw to. Fails with bad_input
/// where the camera or the number of samples is not valid.
[[nodiscard]] Result<KernelFrame> kernel_frame(const Scene &scene, const KernelScene &kernel_scene,
                                               const RenderOptions &options, uint32_t width_px, uint32_t height_px);

} // namespace glint
