// What glint view has to say when it ends.
#include "view_report.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "bench/json_parts.hpp"

namespace glint::cli {
namespace {

using viewer::Quantiles;
using viewer::ShownFrame;

/// Of frames in motion; a picture at rest takes what time it wants.
template <typename Value> Quantiles in_motion(const viewer::FrameLog &log, Value &&value) {
    std::vector<double> values;
    for (const ShownFrame &frame : log.frames()) {
        if (!frame.refines) values.push_back(value(frame));
    }
    return viewer::quantiles_of(std::move(values));
}

std::vector<double> in_ms(std::vector<double> seconds) {
    for (double &value : seconds) value *= 1000.0;
    return seconds;
}

std::string line(const char *name, const Quantiles &of, const char *unit) {
    return fmt::format("{:<18}{:8.2f} {:8.2f} {:8.2f} {}\n", name, of.median, of.p95, of.max, unit);
}

bench::Json json_of(const Quantiles &of) {
    return {{"median", of.median}, {"p95", of.p95}, {"max", of.max}, {"count", of.count}};
}

} // namespace

std::string to_text(const ViewReport &report) {
    const viewer::FrameLog &log = report.log;
    std::string text = fmt::format("{} frames of {} on {} ({}), {}\n", log.count(), report.scene, report.surface,
                                   report.gl_description, report.isa);
    if (log.frames().empty()) return text;
    text += fmt::format("frames in motion  {:8.1f} a second\n", log.fps());
    text += fmt::format("{:<18}{:>8} {:>8} {:>8}\n", "", "median", "p95", "max");
    text += line("interval", viewer::quantiles_of(in_ms(log.intervals_s())), "ms");
    text += line("render", in_motion(log, [](const ShownFrame &f) { return f.render_s * 1000.0; }), "ms");
    text += line("upload", in_motion(log, [](const ShownFrame &f) { return f.upload_s * 1000.0; }), "ms");
    text += line("draw and swap", in_motion(log, [](const ShownFrame &f) { return f.gl_s * 1000.0; }), "ms");
    text += line("input to picture", viewer::quantiles_of(in_ms(log.latencies_s())), "ms");
    text += line("", viewer::quantiles_of(log.latencies_in_frames()), "frames");
    if (const auto stops = log.stops_s(); !stops.empty()) {
        text += line("refining stopped", viewer::quantiles_of(in_ms(stops)), "ms");
    }
    text += line("scale", in_motion(log, [](const ShownFrame &f) { return static_cast<double>(f.scale); }), "");
    text += fmt::format("scale changes     {:8.2f} a second\n", log.scale_changes_per_s());
    return text;
}

std::string to_json(const ViewReport &report) {
    const viewer::FrameLog &log = report.log;
    bench::Json frames = bench::Json::array();
    for (const ShownFrame &f : log.frames()) {
        bench::Json frame = {{"shown_ms", f.shown_s * 1000.0},
                             {"interval_ms", f.interval_s * 1000.0},
                             {"render_ms", f.render_s * 1000.0},
                             {"upload_ms", f.upload_s * 1000.0},
                             {"gl_ms", f.gl_s * 1000.0},
                             {"wait_ms", f.wait_s * 1000.0},
                             {"rays", f.rays},
                             {"width", f.width_px},
                             {"height", f.height_px},
                             {"scale", f.scale},
                             {"depth", f.depth},
                             {"samples", f.samples},
                             {"refines", f.refines}};
        if (f.latency_s >= 0.0) frame["latency_ms"] = f.latency_s * 1000.0;
        if (f.stop_s >= 0.0) frame["stop_ms"] = f.stop_s * 1000.0;
        frames.push_back(std::move(frame));
    }
    return bench::json_text({{"machine", bench::to_json(bench::describe_machine())},
                             {"scene", report.scene},
                             {"surface", report.surface},
                             {"gl", report.gl_description},
                             {"isa", report.isa},
                             {"fps", log.fps()},
                             {"interval_ms", json_of(viewer::quantiles_of(in_ms(log.intervals_s())))},
                             {"latency_ms", json_of(viewer::quantiles_of(in_ms(log.latencies_s())))},
                             {"latency_frames", json_of(viewer::quantiles_of(log.latencies_in_frames()))},
                             {"stop_ms", json_of(viewer::quantiles_of(in_ms(log.stops_s())))},
                             {"scale_changes_per_s", log.scale_changes_per_s()},
                             {"frames", std::move(frames)}});
}

} // namespace glint::cli
