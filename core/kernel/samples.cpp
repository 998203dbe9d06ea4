// Where a pixel's samples lie.
#include "kernel/samples.hpp"

#include "math/hash.hpp"

namespace glint {

SampleGrid sample_grid(uint32_t count, SamplePattern pattern, uint32_t seed) {
    uint32_t rows = 1;
    for (uint32_t i = 1; i * i <= count; ++i) {
        if (count % i == 0) rows = i;
    }
    return {count / rows, rows, pattern, seed, count / rows, rows, 0};
}

SampleGrid one_of(const SampleGrid &grid, uint32_t sample) {
    return {1, 1, grid.pattern, grid.seed, grid.columns, grid.rows, sample};
}

glm::vec2 sample_place(const SampleGrid &grid, uint32_t x, uint32_t y, uint32_t sample) {
    glm::vec2 in_cell(0.5f);
    sample += grid.first;
    if (grid.pattern != SamplePattern::centre) {
        const uint32_t random = scrambled(scrambled(scrambled(grid.seed, sample), y), x);
        in_cell = {unit_number(random), unit_number(scrambled(random))};
        if (grid.pattern == SamplePattern::jittered) return in_cell;
    }
    const uint32_t column = sample % grid.whole_columns, row = sample / grid.whole_columns;
    return {(static_cast<float>(column) + in_cell.x) / static_cast<float>(grid.whole_columns),
            (static_cast<float>(row) + in_cell.y) / static_cast<float>(grid.whole_rows)};
}

} // namespace glint
