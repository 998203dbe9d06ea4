// glint bench frame: whole frames, beside another ray tracer.
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <glint/glint.hpp>

#include "bench/comparison_report.hpp"
#include "bench/find_peer.hpp"
#include "bench/report.hpp"
#include "bench/unsupported_feature.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "isa_option.hpp"
#include "named_scene.hpp"
#include "number_options.hpp"
#include "peer_option.hpp"
#include "scene_options.hpp"
#include "seconds_option.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(Both render the same frames in turns, one each, into 8-bit pixels. The peer is a Whitted ray
tracer on Embree's packets, limited to the same instruction set; beside the scalar kernel, for
which it has no counterpart, it uses all that the machine has. Pictures are compared first: where
more than 0.1 % of the pixels differ by more than 1 of 255, the exit code is 1.

Examples:
  glint bench frame
  glint bench frame --scene mirrors --sizes 512 --depths 0,5 --threads 1 --isa avx2)";

struct BenchFrameOptions {
    SceneOptions scene;
    std::string peer = "embree";
    bench::FrameComparisonOptions comparison;
    std::string json_file;
};

ExitCode verdict(const bench::FrameComparison &comparison) {
    for (const bench::FrameCell &cell : comparison.cells) {
        if (cell.difference.same_picture()) continue;
        complain(fmt::format("{}x{}, depth {}: the peer's picture is another one; its time says nothing", cell.width_px,
                             cell.height_px, cell.depth));
        return ExitCode::failure;
    }
    return ExitCode::ok;
}

ExitCode run(BenchFrameOptions &options) {
    const auto peer = bench::find_peer(options.peer);
    if (!peer) return fail(peer.error());
    const Result<std::filesystem::path> path = find_scene(options.scene.file);
    if (!path) return fail_reading(path.error());
    const Result<SceneFile> file = read_scene(*path, options.scene.read_options(*path));
    if (!file) return fail_reading(file.error());
    complain_about(*file);
    if (const auto feature = bench::unsupported_feature(*file->scene)) {
        complain(fmt::format("{}: the peer cannot draw {}; there is nothing to compare", path->string(), *feature));
        return ExitCode::bad_input;
    }
    if (someone_watches()) {
        options.comparison.on_cell = [](uint32_t size_px, uint32_t depth, unsigned threads) {
            complain(fmt::format("measuring {0}x{0}, depth {1}, {2} thread{3}", size_px, depth, threads,
                                 threads == 1 ? "" : "s"));
        };
    }

    auto comparison = bench::compare_frames(Accel::build(file->scene), **peer, options.comparison);
    if (!comparison) return fail(comparison.error());
    const bench::FrameReport report{bench::describe_machine(), (*peer)->name(), scene_name(options.scene.file),
                                    std::move(*comparison)};
    print(bench::to_text(report));
    if (!options.json_file.empty()) {
        const Status written = bench::write_report(options.json_file, bench::to_json(report));
        if (!written) return fail(written.error());
    }
    return verdict(report.comparison);
}

} // namespace

Command add_bench_frame_command(CLI::App &bench) {
    auto options = std::make_shared<BenchFrameOptions>();
    bench::FrameComparisonOptions &comparison = options->comparison;
    CLI::App *frame = bench.add_subcommand("frame", "Whole frames, beside another ray tracer");
    frame
        ->add_option("--scene", options->scene.file,
                     "A scene file, or the name of one of Glint's scenes (default: cornell, the paper's)")
        ->type_name("NAME|FILE");
    add_peer(*frame, options->peer);
    add_numbers(*frame, "--sizes", comparison.sizes_px, side_bounds, "Picture sizes (default 128,256,512)");
    add_numbers(*frame, "--depths", comparison.depths, depth_bounds, "Recursive rays (default 1,2)");
    add_numbers(*frame, "--threads", comparison.threads, thread_bounds, "Numbers of threads (default 1,2)");
    add_isa(*frame, comparison.isa);
    add_seconds(*frame, comparison.min_seconds,
                "Time each cell at least this long (default 2), and at least 20 frames");
    frame->add_option("--json", options->json_file, "Write the figures as JSON")->type_name("FILE");
    add_scene_options(*frame, options->scene);
    frame->footer(examples);
    return {frame, [options] { return run(*options); }};
}

} // namespace glint::cli
