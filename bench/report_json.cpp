// The report for programs.
#include "bench/report.hpp"

#include <nlohmann/json.hpp>

namespace glint::bench {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Summary &summary) {
    return {{"median", summary.median}, {"min", summary.min}, {"p95", summary.p95}};
}

Json to_json(const Machine &machine, const std::string &gl_description) {
    return {{"cpu", machine.cpu},       {"processors", machine.processors}, {"os", machine.os},
            {"kernel", machine.kernel}, {"compiler", machine.compiler},     {"glint", machine.glint},
            {"gl", gl_description}};
}

Json to_json(const Table &table, const Row &row) {
    return {{"width", row.width_px},
            {"height", row.height_px},
            {"depth", row.depth},
            {"threads", table.threads},
            {"isa", table.isa},
            {"surface", table.surface},
            {"frames", row.frames},
            {"render_ms", to_json(row.render_ms)},
            {"upload_ms", to_json(row.upload_ms)},
            {"gl_ms", to_json(row.gl_ms)},
            {"time_to_image_ms", to_json(row.time_to_image_ms)},
            {"fps", row.fps},
            {"loop_fps", row.loop_fps},
            {"rays", row.rays},
            {"mrays_per_s", row.mrays_per_s}};
}

} // namespace

std::string to_json(const Table &table) {
    Json rows = Json::array();
    for (const Row &row : table.rows) rows.push_back(to_json(table, row));
    const Json report = {
        {"machine", to_json(table.machine, table.gl_description)}, {"scene", table.scene}, {"rows", std::move(rows)}};
    // A file name need not be UTF-8; JSON text must be.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace glint::bench
