// What `glint render --stats` prints.
#pragma once

#include <string>

#include <glint/renderer.hpp>

namespace glint::cli {

[[nodiscard]] std::string render_statistics_text(const Renderer &renderer, const RenderStatistics &render,
                                                 double read_seconds);

/// The tree in one line, without its build time, e.g. "kdtree, 57 nodes, ...".
[[nodiscard]] std::string tree_text(const Accel &accel);

} // namespace glint::cli
