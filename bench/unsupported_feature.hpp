// What a scene has that peers do not know.
#pragma once

#include <optional>
#include <string>

#include <glint/scene.hpp>

namespace glint::bench {

/// Peers trace triangles. The first surface of the scene that is none, in words ("quadrics (object 'ball')"), or
/// nothing.
[[nodiscard]] std::optional<std::string> unsupported_shape(const Scene &scene);

/// Peers draw what the 2013 paper's tracer drew: flat triangles of one colour, glowing meshes with one shadow ray each,
/// mirrors that take the place of their share of the local colour, rays that go straight through glass, one sample in
/// each pixel's middle. The first thing in the scene that is something else, in words, or nothing.
[[nodiscard]] std::optional<std::string> unsupported_feature(const Scene &scene);

} // namespace glint::bench
