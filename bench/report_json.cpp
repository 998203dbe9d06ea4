// The report for programs.
#include "bench/report.hpp"

#include "bench/json_parts.hpp"

namespace glint::bench {
namespace {

Json to_json(const Machine &machine, const std::string &gl_description) {
    Json facts = to_json(machine);
    facts["gl"] = gl_description;
    return facts;
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
    return json_text(
        {{"machine", to_json(table.machine, table.gl_description)}, {"scene", table.scene}, {"rows", std::move(rows)}});
}

} // namespace glint::bench
