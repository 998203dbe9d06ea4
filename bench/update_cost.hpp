// What it costs to move a scene's objects from one frame to the next.
#pragma once

#include <cstdint>

#include <glint/accel.hpp>
#include <glint/result.hpp>

#include "bench/statistics.hpp"

namespace glint::bench {

struct UpdateCost {
    uint32_t moving_objects = 0;
    uint32_t moving_triangles = 0;
    uint32_t updates = 0;
    Summary edit_ms;   ///< scene_at(): poses at a time, and the new scene
    Summary accel_ms;  ///< Accel::update() and Renderer::set_accel()
    Summary update_ms; ///< both
};

/// Goes through so many frames of the scene's animation, a 25th of a second each. Fails where nothing moves, or
/// scene_at() does, or where the last frame does not look as a scene that was built there.
[[nodiscard]] Result<UpdateCost> measure_updates(const std::shared_ptr<const Scene> &scene, uint32_t frames);

} // namespace glint::bench
