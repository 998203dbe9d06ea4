// The timing table of the 2013 paper, measured on this machine: one row for each size and depth.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glint/accel.hpp>
#include <glint/gles/surface.hpp>
#include <glint/renderer.hpp>
#include <glint/result.hpp>

#include "bench/machine.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

struct TableOptions {
    std::vector<uint32_t> sizes_px = {128, 256, 512}; ///< pictures are square
    std::vector<uint32_t> depths = {1, 2};            ///< recursive rays
    unsigned threads = 0;                             ///< 0 = one a processor
    Isa isa = best_isa();                             ///< that traces
    uint32_t min_frames = 50;                         ///< that are timed for each row
    double min_seconds = 1.0;                         ///< of timing for each row
    /// Called before each row is measured, e.g. to show that something goes on. May be empty.
    std::function<void(uint32_t size_px, uint32_t depth)> on_row;
};

/// One size and depth. A frame is: render, upload + glFinish, draw + glFinish. Nothing else is in the timed loop.
struct Row {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    uint32_t depth = 0;
    uint64_t frames = 0;
    Summary render_ms;
    Summary upload_ms; ///< zero without a surface
    Summary gl_ms;     ///< zero without a surface
    Summary time_to_image_ms;
    double fps = 0.0;         ///< 1000 / median time to image
    double loop_fps = 0.0;    ///< frames / wall time of the whole loop
    uint64_t rays = 0;        ///< of one frame, all kinds
    double mrays_per_s = 0.0; ///< at the median render time
};

struct Table {
    Machine machine;
    std::string scene; ///< as the user named it
    unsigned threads = 0;
    std::string isa;
    std::string surface;        ///< kind of the surface, or "none"
    std::string gl_description; ///< of the driver; empty without a surface
    std::vector<Row> rows;      ///< sizes in the order asked for, each with all depths
};

/// Measures every row. `surface` may be nullptr: then upload and draw are left out. After a row's timing the surface is
/// read back and compared with the framebuffer: any differing byte is a failure (io), as is whatever the surface
/// reports. Fails with cancelled when `control` (may be nullptr) says so.
[[nodiscard]] Result<Table> measure_table(std::shared_ptr<const Accel> accel, std::string scene_name,
                                          gles::Surface *surface, const TableOptions &options,
                                          RenderControl *control = nullptr);

} // namespace glint::bench
