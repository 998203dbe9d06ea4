// What each directive does: the handlers that the table in dialects.cpp names.
#pragma once

#include <cstddef>
#include <memory>

#include <glint/scene.hpp>

#include "sdl/dialects.hpp"

namespace glint {

// directives_common.cpp: what the dialects share.
void read_dialect(const Arguments &arguments, SceneDraft &draft);
void read_eye(const Arguments &arguments, SceneDraft &draft);
void read_ortho(const Arguments &arguments, SceneDraft &draft);
void read_size(const Arguments &arguments, SceneDraft &draft);
void read_background(const Arguments &arguments, SceneDraft &draft);
void read_ambient(const Arguments &arguments, SceneDraft &draft);
void read_max_depth(const Arguments &arguments, SceneDraft &draft);
void read_output(const Arguments &arguments, SceneDraft &draft);
void read_mesh_light(const Arguments &arguments, SceneDraft &draft);

// directives_mobile2013.cpp
void read_mobile2013_object(const Arguments &arguments, SceneDraft &draft);

/// Reads the mesh that argument i names and counts its triangles against the limit. Returns nullptr where it cannot be
/// had, after an error.
[[nodiscard]] std::shared_ptr<const Mesh> read_mesh(const Arguments &arguments, size_t i, SceneDraft &draft);

} // namespace glint
