// The report for a spreadsheet.
#include "bench/report.hpp"

#include <fmt/format.h>

namespace glint::bench {
namespace {

/// Quoted as RFC 4180 has it, where that is needed.
std::string field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string fields(const Summary &summary) {
    return fmt::format("{:.4f},{:.4f},{:.4f}", summary.median, summary.min, summary.p95);
}

} // namespace

std::string to_csv(const Table &table) {
    std::string text = "scene,width,height,depth,threads,isa,surface,frames";
    for (const char *quantity : {"render", "upload", "gl", "time_to_image"}) {
        text += fmt::format(",{0}_ms_median,{0}_ms_min,{0}_ms_p95", quantity);
    }
    text += ",fps,loop_fps,rays,mrays_per_s\n";
    for (const Row &row : table.rows) {
        text +=
            fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{:.4f},{:.4f},{},{:.4f}\n", field(table.scene),
                        row.width_px, row.height_px, row.depth, table.threads, field(table.isa), field(table.surface),
                        row.frames, fields(row.render_ms), fields(row.upload_ms), fields(row.gl_ms),
                        fields(row.time_to_image_ms), row.fps, row.loop_fps, row.rays, row.mrays_per_s);
    }
    return text;
}

} // namespace glint::bench
