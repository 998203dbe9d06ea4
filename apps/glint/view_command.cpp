// glint view: a scene in a window, moved through.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include <glint/glint.hpp>
#include <glint/imageio.hpp>

#include "bench/report.hpp"
#include "choice_option.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "interrupt.hpp"
#include "isa_option.hpp"
#include "number_options.hpp"
#include "scene_options.hpp"
#include "steady_memory.hpp"
#include "view_report.hpp"
#include "viewer/viewer.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(In the window: left drag orbits, right drag or two fingers pan, the wheel zooms to the cursor,
W A S D Q E fly (Shift: faster), R goes back, F frames the scene, 0-9 set the depth, + and - the
threads, Space pauses, P saves a screenshot, a click shows the pixel's rays, Tab hides the
figures, H shows all this, Esc quits.

The frame rate is held: resolution gives way first, then depth. At rest the picture comes back in
full and gets smoother, up to 16 samples a pixel.

A script is a text file with a line for each event, a time in seconds before it:
  0.5  press left 100 200      or release, with left, middle or right
  0.9  move 150 200
  1    drag left 10 10 90 10 2 press, move evenly for 2 seconds, release
  3.5  wheel -2 256 256        notches, with the cursor there
  4    key w down              or up; without either, pressed and released
  5    finger 1 down 100 100   or move, or up
  6    resize 640 480
  7    lose-context            the graphics context is thrown away
  8    close

Examples:
  glint view cornell.sdl
  glint view big.sdl --fps 30 --stats
  glint view cornell.sdl --surface offscreen --script walk.txt --record frames
  glint view cornell.sdl --surface offscreen --frames 1 --screenshot first.png)";

enum class SurfaceChoice { window, offscreen };

struct ViewCommandOptions {
    SceneOptions scene;
    std::optional<Size> size;
    std::optional<uint32_t> depth, threads, fps;
    std::optional<uint64_t> frames;
    AccelKind accel = AccelKind::automatic;
    Isa isa = best_isa();
    Transfer transfer = Transfer::linear;
    SurfaceChoice surface = SurfaceChoice::window;
    std::string screenshot, record, script, json;
    bool stats = false;
    bool no_figures = false;
};

/// Refuses, before anything is read, what could not be written at the end.
ExitCode check_targets(const ViewCommandOptions &options) {
    if (!options.screenshot.empty()) {
        if (const Status writable = check_image_file(options.screenshot); !writable) {
            const ExitCode code = fail(writable.error());
            return writable.error().code == ErrorCode::bad_input ? ExitCode::usage : code;
        }
    }
    if (!options.record.empty()) {
        std::error_code error;
        std::filesystem::create_directories(options.record, error);
        if (error || !std::filesystem::is_directory(options.record, error)) {
            complain(fmt::format("--record: {} is not a folder and cannot be made one", options.record));
            return ExitCode::failure;
        }
    }
    return ExitCode::ok;
}

ExitCode run(const ViewCommandOptions &options) {
    if (const ExitCode code = check_targets(options); code != ExitCode::ok) return code;
    viewer::ViewOptions view;
    if (!options.script.empty()) {
        Result<viewer::Script> script = viewer::Script::read(options.script);
        if (!script) return fail_reading(script.error());
        view.script = std::move(*script);
    }
    const Result<SceneFile> file = read_scene(options.scene.file, options.scene.read_options(options.scene.file));
    if (!file) return fail_reading(file.error());
    complain_about(*file);

    const PictureSettings &wanted = file->scene->picture();
    const Size size = options.size.value_or(Size{wanted.width_px, wanted.height_px});
    if (uint64_t{size.width_px} * size.height_px > options.scene.pixel_limit()) {
        complain(fmt::format("--size: {}x{} is more than {} pixels; raise the limit with --max-pixels", size.width_px,
                             size.height_px, options.scene.pixel_limit()));
        return ExitCode::usage;
    }
    view.name = std::filesystem::path(options.scene.file).filename().string();
    const bool is_offscreen = options.surface == SurfaceChoice::offscreen;
    auto window = is_offscreen ? viewer::open_offscreen(size.width_px, size.height_px)
                               : viewer::open_on_desktop(view.name + " - Glint", size.width_px, size.height_px);
    if (!window) return fail(window.error());

    view.scene = file->scene;
    view.threads = options.threads.value_or(std::max(1u, std::thread::hardware_concurrency()));
    view.accel = Accel::build(view.scene, {.kind = options.accel, .threads = view.threads});
    view.isa = options.isa;
    view.depth = options.depth.value_or(wanted.max_depth);
    view.transfer = options.transfer;
    if (options.fps) view.fps = *options.fps;
    view.shows_figures = !options.no_figures;
    view.frames = options.frames;
    view.ends_at_rest = is_offscreen && !options.frames;
    if (!options.screenshot.empty()) view.screenshot = options.screenshot;
    if (!options.record.empty()) view.record_folder = options.record;
    view.say = [](const std::string &line) { complain(line); };
    RenderControl control;
    const InterruptGuard guard(control);
    view.is_interrupted = [&] { return control.cancelled(); };

    keep_memory_steady();
    const std::string surface = (*window)->kind(), gl = (*window)->gl_description();
    const Result<viewer::FrameLog> log = viewer::view(**window, std::move(view));
    if (!log) return fail(log.error());
    const ViewReport report{options.scene.file, surface, gl, std::string(isa_name(options.isa)), *log};
    if (options.stats) print(to_text(report));
    if (!options.json.empty()) {
        if (const Status written = bench::write_report(options.json, to_json(report)); !written) {
            return fail(written.error());
        }
    }
    return control.cancelled() ? ExitCode::interrupted : ExitCode::ok;
}

} // namespace

Command add_view_command(CLI::App &parser) {
    auto options = std::make_shared<ViewCommandOptions>();
    CLI::App *view = parser.add_subcommand("view", "Show a scene in a window and move through it");
    view->add_option("SCENE", options->scene.file, "The scene file (SDL)")->required()->type_name("");
    add_size(*view, "--size", options->size, "The window's size (default: the scene's)");
    add_number(*view, "--depth", options->depth, depth_bounds, "Most recursive rays in a row (default: the scene's)");
    add_number(*view, "--threads", options->threads, thread_bounds, "Threads (default: one a processor)");
    add_isa(*view, options->isa);
    add_choice(*view, "--accel", options->accel,
               {{"automatic", AccelKind::automatic},
                {"kdtree", AccelKind::kdtree},
                {"bvh", AccelKind::bvh},
                {"brute", AccelKind::brute}},
               "How rays find triangles, as in glint render");
    add_choice(*view, "--transfer", options->transfer, {{"linear", Transfer::linear}, {"srgb", Transfer::srgb}},
               "How colours become 8 bits, as in glint render");
    add_number(*view, "--fps", options->fps, {1, 1000},
               "Frames a second to hold and not to go beyond (default: the display's)");
    add_choice(*view, "--surface", options->surface,
               {{"window", SurfaceChoice::window}, {"offscreen", SurfaceChoice::offscreen}},
               "Where to: a window (the default), or the same without any display");
    add_number(*view, "--frames", options->frames, {1, uint64_t{1} << 40}, "End after so many frames");
    view->add_option("--screenshot", options->screenshot, "Save the last frame, without the figures, when it ends")
        ->type_name("FILE");
    view->add_option("--record", options->record,
                     "Save every frame as FOLDER/frame.0000.png and so on, in full resolution; time goes by frames, "
                     "60 or --fps a second")
        ->type_name("FOLDER");
    view->add_option("--script", options->script, "Take input events from a text file; see below")->type_name("FILE");
    view->add_flag("--no-figures", options->no_figures, "Begin without the figures in the corner");
    view->add_flag("--stats", options->stats, "Print frame times and latencies when it ends");
    view->add_option("--json", options->json, "Write every frame's times when it ends")->type_name("FILE");
    add_scene_options(*view, options->scene);
    view->footer(examples);
    return {view, [options] { return run(*options); }};
}

} // namespace glint::cli
