// How good and how dear it is to trace fewer pixels than are shown: pictures of a lower resolution, enlarged by the
// presenter's filters, beside the picture in full.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glint/accel.hpp>
#include <glint/gles/presenter.hpp>
#include <glint/renderer.hpp>
#include <glint/result.hpp>

#include "bench/machine.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

struct UpscaleOptions {
    uint32_t width_px = 512; ///< of what is shown
    uint32_t height_px = 512;
    std::vector<double> scales = {0.25, 0.35, 0.5, 0.71}; ///< of each side; from above 0 to 1
    unsigned threads = 0;                                 ///< that trace; 0 = one a processor
    double min_seconds = 0.3;                             ///< of timing for each cell
    /// Called before each scene and scale. May be empty.
    std::function<void(std::string_view scene, double scale)> on_scale;
};

/// One filter at one scale.
struct UpscaleCell {
    std::string filter; ///< "nearest", "bilinear", "sharp"
    double psnr_db = 0.0;
    double ssim = 0.0;
    uint64_t draws = 0; ///< that were timed
    Summary draw_ms;    ///< draw and glFinish
};

struct UpscaleRow {
    std::string scene;
    double scale = 1.0;
    uint32_t traced_width_px = 0;
    uint32_t traced_height_px = 0;
    std::vector<UpscaleCell> cells; ///< one a filter, in upscale_filters()'s order
};

struct UpscaleReport {
    Machine machine;
    std::string surface;
    std::string gl_description;
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    std::vector<UpscaleRow> rows;
};

struct NamedFilter {
    gles::Filter filter;
    std::string_view name;
};
[[nodiscard]] const std::vector<NamedFilter> &upscale_filters();

/// Measures a scene at every scale and appends the rows to `report`, whose size the surface has. Pictures in full size
/// must arrive to the byte; otherwise it fails with io, as it does with whatever the renderer and the surface report.
[[nodiscard]] Status measure_upscaling(std::shared_ptr<const Accel> accel, const std::string &scene_name,
                                       gles::Surface &surface, const UpscaleOptions &options, UpscaleReport &report,
                                       RenderControl *control = nullptr);

/// A table a person can read.
[[nodiscard]] std::string to_text(const UpscaleReport &report);
/// `{"machine": {...}, "width": ..., "height": ..., "rows": [...]}`, in milliseconds and decibels.
[[nodiscard]] std::string to_json(const UpscaleReport &report);

} // namespace glint::bench
