// Comparisons with a peer, for programs.
#include "bench/comparison_report.hpp"

#include <nlohmann/json.hpp>

#include "bench/json_parts.hpp"

namespace glint::bench {
namespace {

Json to_json(const KernelReport &report, const ClassRow &row) {
    const double rays = static_cast<double>(row.agreement.rays);
    return {{"mesh", report.mesh},
            {"triangles", report.triangles},
            {"class", row.ray_class},
            {"threads", row.threads},
            {"isa", report.isa},
            {"glint_mrays", row.glint_mrays},
            {"peer_mrays", row.peer_mrays},
            {"peer_kernel", row.peer_kernel},
            {"ratio", row.ratio()},
            {"hits_equal", row.agreement.hits_equal()},
            {"rays", row.agreement.rays},
            {"glint_hits", row.agreement.glint_hits},
            {"peer_hits", row.agreement.peer_hits},
            {"same_share", static_cast<double>(row.agreement.same) / rays},
            {"passes", row.passes},
            {"glint_ms", to_json(row.glint_ms)},
            {"peer_ms", to_json(row.peer_ms)}};
}

Json to_json(const KernelReport &report, const BuildRow &row) {
    return {{"mesh", report.mesh},
            {"triangles", row.triangles},
            {"threads", row.threads},
            {"glint_ms", row.glint_ms.median},
            {"glint_bytes_per_triangle", row.glint_bytes_per_triangle},
            {"peer_ms", row.peer_ms.median},
            {"peer_high_ms", row.peer_high_ms.median},
            {"peer_bytes_per_triangle", row.peer_bytes_per_triangle},
            {"peer_high_bytes_per_triangle", row.peer_high_bytes_per_triangle},
            {"glint_spread_ms", to_json(row.glint_ms)},
            {"peer_spread_ms", to_json(row.peer_ms)},
            {"peer_high_spread_ms", to_json(row.peer_high_ms)}};
}

Json to_json(const FrameReport &report, const FrameCell &cell) {
    return {{"scene", report.scene},
            {"width", cell.width_px},
            {"height", cell.height_px},
            {"depth", cell.depth},
            {"threads", cell.threads},
            {"isa", report.comparison.isa},
            {"glint_ms", cell.glint_ms.median},
            {"peer_ms", cell.peer_ms.median},
            {"ratio", cell.ratio()},
            {"differing_pixels", cell.difference.differing},
            {"same_picture", cell.difference.same_picture()},
            {"peer_kernel", cell.peer_kernel},
            {"frames", cell.frames},
            {"glint_spread_ms", to_json(cell.glint_ms)},
            {"peer_spread_ms", to_json(cell.peer_ms)}};
}

} // namespace

std::string to_json(const FrameReport &report) {
    Json cells = Json::array();
    for (const FrameCell &cell : report.comparison.cells) cells.push_back(to_json(report, cell));
    return json_text({{"machine", to_json(report.machine)}, {"peer", report.peer}, {"cells", std::move(cells)}});
}

std::string to_json(const KernelReport &report) {
    Json classes = Json::array(), builds = Json::array();
    for (const ClassRow &row : report.classes) classes.push_back(to_json(report, row));
    for (const BuildRow &row : report.builds) builds.push_back(to_json(report, row));
    return json_text({{"machine", to_json(report.machine)},
                      {"peer", report.peer},
                      {"classes", std::move(classes)},
                      {"builds", std::move(builds)}});
}

} // namespace glint::bench
