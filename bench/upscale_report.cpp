// The measurement of enlarged pictures, for people and for programs.
#include <fmt/format.h>

#include "bench/json_parts.hpp"
#include "bench/upscale.hpp"

namespace glint::bench {
namespace {

Json to_json(const UpscaleRow &row) {
    Json filters = Json::array();
    for (const UpscaleCell &cell : row.cells) {
        filters.push_back({{"filter", cell.filter},
                           {"psnr_db", cell.psnr_db},
                           {"ssim", cell.ssim},
                           {"draws", cell.draws},
                           {"draw_ms", to_json(cell.draw_ms)}});
    }
    return {{"scene", row.scene},
            {"scale", row.scale},
            {"traced_width", row.traced_width_px},
            {"traced_height", row.traced_height_px},
            {"filters", std::move(filters)}};
}

} // namespace

std::string to_text(const UpscaleReport &report) {
    std::string text = fmt::format("Machine  {}\nSurface  {}, {}, {}x{}\n\n", report.machine.cpu, report.surface,
                                   report.gl_description, report.width_px, report.height_px);
    text += fmt::format("{:<16}{:>6}{:>11}  {:<9}{:>9}{:>9}{:>10}{:>10}\n", "Scene", "scale", "traced", "filter",
                        "PSNR, dB", "SSIM", "draw, ms", "least");
    for (const UpscaleRow &row : report.rows) {
        for (const UpscaleCell &cell : row.cells) {
            text += fmt::format("{:<16}{:>6.2f}{:>11}  {:<9}{:>9.2f}{:>9.4f}{:>10.3f}{:>10.3f}\n", row.scene, row.scale,
                                fmt::format("{}x{}", row.traced_width_px, row.traced_height_px), cell.filter,
                                cell.psnr_db, cell.ssim, cell.draw_ms.median, cell.draw_ms.min);
        }
    }
    return text;
}

std::string to_json(const UpscaleReport &report) {
    Json machine = to_json(report.machine);
    machine["gl"] = report.gl_description;
    Json rows = Json::array();
    for (const UpscaleRow &row : report.rows) rows.push_back(to_json(row));
    return json_text({{"machine", std::move(machine)},
                      {"surface", report.surface},
                      {"width", report.width_px},
                      {"height", report.height_px},
                      {"rows", std::move(rows)}});
}

} // namespace glint::bench
