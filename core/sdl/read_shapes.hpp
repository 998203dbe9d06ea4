// Meshes and quadrics as directives name them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include <glint/scene.hpp>

#include "sdl/arguments.hpp"
#include "sdl/scene_draft.hpp"

namespace glint {

/// Reads the mesh that argument i names, moved by `offset`, and counts its triangles against the limit. `file` becomes
/// the place where it was found. Returns nullptr where it cannot be had, after an error.
[[nodiscard]] std::shared_ptr<const Mesh> read_mesh(const Arguments &arguments, size_t i, SceneDraft &draft,
                                                    const Vector &offset, std::filesystem::path *file);

/// Reads the mesh and the materials that argument i names, into the parts of an `object` line. Triangles are counted
/// likewise; there are no parts where it cannot be had.
[[nodiscard]] ObjectDraft read_model(const Arguments &arguments, size_t i, SceneDraft &draft);

/// Ten coefficients from argument i on, in the convention of ray2005 (and of glint::Quadric): mixed and linear terms
/// count twice. What is wrong with them is reported.
[[nodiscard]] Quadric read_quadric(const Arguments &arguments, size_t i);

/// The same in the convention of cg-path-tracer: every term counts once, and the mixed ones are ordered xy, xz, yz.
[[nodiscard]] Quadric read_cg_quadric_coefficients(const Arguments &arguments, size_t i);

} // namespace glint
