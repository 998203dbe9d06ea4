// Four kinds of rays that a renderer asks about, made from a scene: primary, shadow, mirror, diffuse.
#pragma once

#include <cstdint>
#include <vector>

#include <glint/ray_query.hpp>
#include <glint/scene.hpp>

#include "bench/peers/ray_set.hpp"

namespace glint::bench {

/// From where a scene is looked at, and from where it is lit.
struct Viewpoint {
    Camera camera;
    Point light;
};

/// The scene's own camera and its first light's centroid. The scene has a light.
[[nodiscard]] Viewpoint viewpoint_of(const Scene &scene);
/// A square camera that sees the scene from direction (0.3, 0.4, 1) under 45 degrees so that it fills four fifths of
/// the height (or all of the width, where that comes first), and a light at two radii of its bounding sphere in
/// direction (1, 1.5, 1), unnormalised.
[[nodiscard]] Viewpoint viewpoint_framing(const Scene &scene);

/// The classes, in this order; those after the first are left empty where no primary ray hits anything:
///
/// - primary: through the centres of size x size pixels, pixels by blocks of 4 x 4 in tiles of 16 x 16;
/// - shadow: any hit between the light, where the ray starts, and just before (a ten-thousandth) every primary hit;
/// - mirror: the primary rays' reflections about the hit triangle's plane;
/// - diffuse: one a primary hit, cosine-distributed about the normal that faces the viewer, the same in every run.
///
/// The last three follow the order of the primary rays that hit. `query` answers for `scene`; nothing is timed here.
[[nodiscard]] std::vector<RaySet> make_ray_classes(const Scene &scene, const RayQuery &query,
                                                   const Viewpoint &viewpoint, uint32_t size_px);

} // namespace glint::bench
