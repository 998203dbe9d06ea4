// glint bench present: what showing a picture costs, by the presenter and by the other ways there are.
#include <memory>
#include <optional>
#include <string>

#include "bench/present.hpp"
#include "bench/report.hpp"
#include "bench/surface_choice.hpp"
#include "choice_option.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "number_options.hpp"
#include "seconds_option.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(A picture is uploaded (then glFinish) and drawn in its own size (then glFinish): by the
presenter, and by each way that OpenGL ES has. After each the surface is read back: a byte that
is not the picture's fails the run.

Examples:
  glint bench present
  glint bench present --size 1280x720 --surface osmesa --json present.json)";

struct BenchPresentOptions {
    std::optional<Size> size;
    bench::SurfaceKind surface = bench::SurfaceKind::egl;
    double min_seconds = 0.5;
    std::string json_file;
};

ExitCode run(const BenchPresentOptions &options) {
    const Size size = options.size.value_or(Size{512, 512});
    const auto opened = bench::open_surface(options.surface, size.width_px, size.height_px);
    if (!opened) return fail(opened.error());
    for (const std::string &note : opened->notes) complain(note);
    if (!opened->surface) {
        complain("there is no surface to show pictures on; 'glint surfaces' says why");
        return ExitCode::failure;
    }
    const Result<bench::PresentReport> report = bench::measure_presenting(*opened->surface, options.min_seconds);
    if (!report) return fail(report.error());
    print(bench::to_text(*report));
    if (!options.json_file.empty()) {
        const Status written = bench::write_report(options.json_file, bench::to_json(*report));
        if (!written) return fail(written.error());
    }
    return ExitCode::ok;
}

} // namespace

Command add_bench_present_command(CLI::App &bench) {
    auto options = std::make_shared<BenchPresentOptions>();
    CLI::App *present = bench.add_subcommand("present", "Showing a picture: the presenter and other ways");
    add_size(*present, "--size", options->size, "Size of the picture (default 512x512)");
    add_choice(*present, "--surface", options->surface,
               {{"egl", bench::SurfaceKind::egl}, {"osmesa", bench::SurfaceKind::osmesa}},
               "What pictures are shown on: egl (default; falls back to osmesa), or osmesa");
    add_seconds(*present, options->min_seconds, "Time each way at least this long (default 0.5)");
    present->add_option("--json", options->json_file, "Write the figures as JSON")->type_name("FILE");
    present->footer(examples);
    return {present, [options] { return run(*options); }};
}

} // namespace glint::cli
