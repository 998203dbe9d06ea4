// A pixel's rays as rows of a panel.
#pragma once

#include <cstdint>

#include <glint/ray_tree.hpp>

#include "viewer/hud/panel.hpp"

namespace glint::viewer {

/// Rows that the whole list would take, with its head.
[[nodiscard]] int ray_list_rows(const RayTree &tree);

/// Columns that are enough for most lists.
inline constexpr int ray_list_columns = 58;

/// The pixel and its colour, then a row for each ray from `first_ray` on, indented below the one that sent it: the
/// colour that comes along it, its weight, its length and what it ends at. The last row says how many did not fit.
void draw_ray_list(const Panel &panel, const RayTree &tree, uint32_t first_ray);

} // namespace glint::viewer
