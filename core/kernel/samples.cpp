// Where a pixel's samples lie.
#include "kernel/samples.hpp"

#include "math/hash.hpp"

namespace glint {

SampleGrid sample_grid(uint32_t count, SamplePattern pattern, uint32_t seed) {
    uint32_t rows = 1;
    for (uint32_t i = 1; i * i <= count; ++i) {
        if (count % i == 0) rows = i;
    }
    return {count / rows, rows, pattern, seed};
}

glm::vec2 sample_place(const SampleGrid &grid, uint32_t x, uint32_t y, uint32_t sample) {
    glm::vec2 in_cell(0.5f);
    if (grid.pattern != SamplePattern::centre) {
        const uint32_t random = scrambled(scrambled(scrambled(grid.seed, sample), y), x);
        in_cell = {unit_number(random), unit_number(scrambled(random))};
        if (grid.pattern == SamplePattern::jittered) return in_cell;
    }
    return {(static_cast<float>(sample % grid.columns) + in_cell.x) / static_cast<float>(grid.columns),
            (static_cast<float>(sample / grid.columns) + in_cell.y) / static_cast<float>(grid.rows)};
}

} // namespace glint
