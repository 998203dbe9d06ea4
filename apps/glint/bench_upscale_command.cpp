// glint bench upscale: what showing fewer pixels than the window has costs in quality, and scaling in time.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <glint/glint.hpp>

#include "bench/report.hpp"
#include "bench/surface_choice.hpp"
#include "bench/upscale.hpp"
#include "choice_option.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "interrupt.hpp"
#include "named_scene.hpp"
#include "number_options.hpp"
#include "scene_options.hpp"
#include "seconds_option.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(Each scene is traced in full and at each scale; the small pictures are enlarged by each of the
presenter's filters and compared with the full one: PSNR of the bytes, SSIM of the brightness.
Draws are timed with glFinish.

Examples:
  glint bench upscale
  glint bench upscale --scenes cornell,mirrors --scales 0.5 --size 1280x720 --json upscale.json)";

struct BenchUpscaleOptions {
    SceneOptions scene;
    std::vector<std::string> scenes = {"cornell"};
    std::optional<Size> size;
    std::optional<uint32_t> threads;
    bench::UpscaleOptions upscale;
    bench::SurfaceKind surface = bench::SurfaceKind::egl;
    std::string json_file;
};

ExitCode run(BenchUpscaleOptions &options) {
    if (options.size) {
        options.upscale.width_px = options.size->width_px;
        options.upscale.height_px = options.size->height_px;
    }
    options.upscale.threads = options.threads.value_or(0);
    const auto opened = bench::open_surface(options.surface, options.upscale.width_px, options.upscale.height_px);
    if (!opened) return fail(opened.error());
    for (const std::string &note : opened->notes) complain(note);
    if (!opened->surface) {
        complain("there is no surface to enlarge pictures on; 'glint surfaces' says why");
        return ExitCode::failure;
    }
    if (someone_watches()) {
        options.upscale.on_scale = [](std::string_view scene, double scale) {
            complain(fmt::format("measuring {}, scale {}", scene, scale));
        };
    }

    bench::UpscaleReport report{bench::describe_machine(), opened->surface->kind(),   opened->surface->gl_description(),
                                options.upscale.width_px,  options.upscale.height_px, {}};
    RenderControl control;
    const InterruptGuard guard(control);
    for (const std::string &name : options.scenes) {
        const Result<std::filesystem::path> path = find_scene(name);
        if (!path) return fail_reading(path.error());
        const Result<SceneFile> file = read_scene(*path, options.scene.read_options(*path));
        if (!file) return fail_reading(file.error());
        complain_about(*file);
        const Status measured =
            bench::measure_upscaling(Accel::build(file->scene, {.threads = options.upscale.threads}), scene_name(name),
                                     *opened->surface, options.upscale, report, &control);
        if (!measured) return fail(measured.error());
    }
    print(bench::to_text(report));
    if (!options.json_file.empty()) {
        const Status written = bench::write_report(options.json_file, bench::to_json(report));
        if (!written) return fail(written.error());
    }
    return ExitCode::ok;
}

} // namespace

Command add_bench_upscale_command(CLI::App &bench) {
    auto options = std::make_shared<BenchUpscaleOptions>();
    CLI::App *upscale = bench.add_subcommand("upscale", "Pictures of lower resolution, enlarged: quality and time");
    upscale
        ->add_option("--scenes", options->scenes,
                     "Scene files, or names of Glint's scenes (default: cornell, the paper's)")
        ->delimiter(',')
        ->type_name("NAME|FILE,...");
    add_size(*upscale, "--size", options->size, "Size of what is shown (default 512x512)");
    upscale
        ->add_option("--scales", options->upscale.scales,
                     "Of each side, above 0 and at most 1 (default 0.25,0.35,0.5,0.71)")
        ->delimiter(',')
        ->check(CLI::Range(0.001, 1.0))
        ->type_name("F,F,...");
    add_number(*upscale, "--threads", options->threads, thread_bounds, "Threads (default: one a processor)");
    add_choice(*upscale, "--surface", options->surface,
               {{"egl", bench::SurfaceKind::egl}, {"osmesa", bench::SurfaceKind::osmesa}},
               "What pictures are shown on: egl (default; falls back to osmesa), or osmesa");
    add_seconds(*upscale, options->upscale.min_seconds, "Time each filter at least this long (default 0.3)");
    upscale->add_option("--json", options->json_file, "Write the figures as JSON")->type_name("FILE");
    add_scene_options(*upscale, options->scene);
    upscale->footer(examples);
    return {upscale, [options] { return run(*options); }};
}

} // namespace glint::cli
