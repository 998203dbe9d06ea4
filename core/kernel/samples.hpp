// Where a pixel's samples lie.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include <glint/scene.hpp>

namespace glint {

/// The samples of a pixel that a render takes: columns * rows of them, a grid where the pattern has one.
struct SampleGrid {
    uint32_t columns, rows;
    SamplePattern pattern;
    uint32_t seed;
    /// The grid that they belong to, and which of its samples is the first taken: another than their own where a
    /// picture is rendered sample by sample.
    uint32_t whole_columns, whole_rows, first;
};

/// The grid of so many cells that is nearest to a square.
[[nodiscard]] SampleGrid sample_grid(uint32_t count, SamplePattern pattern, uint32_t seed);

/// One of the grid's samples alone.
[[nodiscard]] SampleGrid one_of(const SampleGrid &grid, uint32_t sample);

/// Place of a sample in pixel x, y: from its left and its top edge, in pixels.
[[nodiscard]] glm::vec2 sample_place(const SampleGrid &grid, uint32_t x, uint32_t y, uint32_t sample);

} // namespace glint
