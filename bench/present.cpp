// What showing a picture costs, by the presenter and by the other ways there are.
#include "bench/present.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <utility>

#include <fmt/format.h>

#include <glint/gles/reliable_presenter.hpp>

#include "bench/json_parts.hpp"
#include "bench/presenting/ways.hpp"
#include "bench/shown_picture.hpp"

namespace glint::bench {
namespace {

/// Every byte random: nothing that could be shown wrongly and look right.
Result<Framebuffer> noise(uint32_t width_px, uint32_t height_px) {
    Result<Framebuffer> picture = Framebuffer::create(width_px, height_px, /*with_radiance=*/false);
    if (!picture) return picture;
    std::mt19937 random(1);
    std::generate_n(picture->rgba8(), picture->rgba8_stride_bytes() * height_px,
                    [&] { return static_cast<uint8_t>(random()); });
    return picture;
}

PresentRow row_of(std::string upload, std::string draw, std::vector<double> upload_ms, std::vector<double> draw_ms) {
    PresentRow row;
    row.upload = std::move(upload);
    row.draw = std::move(draw);
    row.frames = upload_ms.size();
    row.upload_ms = summarize(std::move(upload_ms));
    row.draw_ms = summarize(std::move(draw_ms));
    return row;
}

Result<PresentRow> measure_presenter(gles::Surface &surface, const Framebuffer &picture, double min_seconds) {
    constexpr size_t min_frames = 10, warm_up = 3;
    gles::ReliablePresenter presenter([&surface](bool) -> Result<gles::ProcLoader> {
        if (Status current = surface.make_current(); !current) return current.error();
        return surface.proc_loader();
    });
    gles::Layer layer;
    layer.picture = picture;
    layer.width_px = static_cast<int>(picture.width_px());
    layer.height_px = static_cast<int>(picture.height_px());
    std::vector<double> upload_ms, draw_ms;
    double sum_ms = 0.0;
    for (size_t frame = 0; frame < warm_up + min_frames || sum_ms < 1000.0 * min_seconds; ++frame) {
        const Result<gles::ShowTimes> times = presenter.show({&layer, 1}, {.finish = true});
        if (!times) return times.error();
        if (frame < warm_up) continue;
        upload_ms.push_back(1000.0 * times->upload_s);
        draw_ms.push_back(1000.0 * times->draw_s);
        sum_ms += upload_ms.back() + draw_ms.back();
    }
    const Result<std::vector<uint8_t>> shown = surface.read_back();
    if (!shown) return shown.error();
    if (Status same = compare_shown(picture, *shown); !same) return same.error();
    return row_of("presenter", "presenter", std::move(upload_ms), std::move(draw_ms));
}

} // namespace

Result<PresentReport> measure_presenting(gles::Surface &surface, double min_seconds) {
    if (Status current = surface.make_current(); !current) return current.error();
    PresentReport report{describe_machine(), surface.kind(),      surface.gl_description(),
                         surface.width_px(), surface.height_px(), {}};
    const Result<Framebuffer> picture = noise(surface.width_px(), surface.height_px());
    if (!picture) return picture.error();
    Result<PresentRow> presenter = measure_presenter(surface, *picture, min_seconds);
    if (!presenter) return presenter.error();
    report.rows.push_back(std::move(*presenter));
    Result<std::vector<WayTimes>> ways = time_ways(surface, *picture, min_seconds);
    if (!ways) return ways.error();
    for (WayTimes &way : *ways) {
        report.rows.push_back(
            row_of(way_name(way.upload), way_name(way.draw), std::move(way.upload_ms), std::move(way.draw_ms)));
        report.rows.back().missing = way.missing;
    }
    return report;
}

std::string to_text(const PresentReport &report) {
    std::string text = fmt::format("Machine  {}\nSurface  {}, {}, {}x{}\n\n", report.machine.cpu, report.surface,
                                   report.gl_description, report.width_px, report.height_px);
    text += fmt::format("{:<14}{:<14}{:>11}{:>9}{:>11}{:>9}{:>9}\n", "Upload", "Draw", "upload, ms", "least",
                        "draw, ms", "least", "frames");
    for (const PresentRow &row : report.rows) {
        text += fmt::format("{:<14}{:<14}", row.upload, row.draw);
        if (!row.missing.empty()) {
            text += "  " + row.missing + '\n';
            continue;
        }
        text += fmt::format("{:>11.3f}{:>9.3f}{:>11.3f}{:>9.3f}{:>9}\n", row.upload_ms.median, row.upload_ms.min,
                            row.draw_ms.median, row.draw_ms.min, row.frames);
    }
    return text;
}

std::string to_json(const PresentReport &report) {
    Json machine = to_json(report.machine);
    machine["gl"] = report.gl_description;
    Json rows = Json::array();
    for (const PresentRow &row : report.rows) {
        rows.push_back({{"upload", row.upload},
                        {"draw", row.draw},
                        {"missing", row.missing},
                        {"frames", row.frames},
                        {"upload_ms", to_json(row.upload_ms)},
                        {"draw_ms", to_json(row.draw_ms)}});
    }
    return json_text({{"machine", std::move(machine)},
                      {"surface", report.surface},
                      {"width", report.width_px},
                      {"height", report.height_px},
                      {"rows", std::move(rows)}});
}

} // namespace glint::bench
