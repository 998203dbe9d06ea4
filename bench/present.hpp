// What showing a picture costs, by the presenter and by the other ways there are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glint/framebuffer.hpp>
#include <glint/gles/surface.hpp>
#include <glint/result.hpp>

#include "bench/machine.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

/// One way: its times, or why there are none.
struct PresentRow {
    std::string upload; ///< "presenter" for the product's own way, which is first
    std::string draw;
    std::string missing;
    uint64_t frames = 0;
    Summary upload_ms; ///< upload and glFinish
    Summary draw_ms;   ///< draw and glFinish
};

struct PresentReport {
    Machine machine;
    std::string surface;
    std::string gl_description;
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    std::vector<PresentRow> rows;
};

/// Measures all ways with a picture of the surface's size, which is checked to be on the surface afterwards.
/// `min_seconds` is for each way.
[[nodiscard]] Result<PresentReport> measure_presenting(gles::Surface &surface, double min_seconds);

/// A table a person can read.
[[nodiscard]] std::string to_text(const PresentReport &report);
/// `{"machine": {...}, "width": ..., "height": ..., "rows": [...]}`, in milliseconds.
[[nodiscard]] std::string to_json(const PresentReport &report);

} // namespace glint::bench
