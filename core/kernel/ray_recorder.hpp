// Who wants to know of every ray behind a pixel, and the function that tells: the scalar kernel's own.
#pragma once

#include "kernel/incoming_light.hpp"
#include "kernel/kernel.hpp"

namespace glint {

/// Told of each ray when it has been traced: what it meets, the shadow rays from there, what it shows, the rays that it
/// sends on. Those are traced later, the one that was told last first.
class RayRecorder {
public:
    virtual void meets(const PendingRay &ray, const Hit &hit) = 0;
    /// A shadow ray to the scene's entry `light`, and the share of the light that comes through.
    virtual void casts(uint32_t light, const ShadowRay &shadow, const SurfacePoint &point, float share) = 0;
    /// What the light of the last shadow ray adds to the local colour; not told where nothing comes through.
    virtual void lights(const Color &color) = 0;
    /// Adds weight * color to the pixel.
    virtual void shows(float weight, const Color &color) = 0;
    virtual void sends(bool mirrored) = 0;

protected:
    ~RayRecorder() = default;
};

/// The pixel's linear colour, of which scalar_kernel makes pictures. `recorder` may be nullptr.
[[nodiscard]] Color pixel_color(const KernelScene &scene, const KernelFrame &frame, uint32_t x, uint32_t y,
                                KernelScratch &scratch, RayRecorder *recorder);

/// The byte that the picture has for a channel of that colour.
[[nodiscard]] uint8_t pixel_byte(const KernelFrame &frame, float channel);

} // namespace glint
