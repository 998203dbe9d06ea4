// glint bench table: the 2013 paper's timing table, measured on this machine.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <glint/glint.hpp>

#include "bench/report.hpp"
#include "bench/surface_choice.hpp"
#include "bench/table.hpp"
#include "choice_option.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "interrupt.hpp"
#include "isa_option.hpp"
#include "named_scene.hpp"
#include "number_options.hpp"
#include "scene_options.hpp"
#include "seconds_option.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(A frame is rendered, uploaded as a texture (then glFinish) and drawn on two triangles (then
glFinish). After each row the surface is read back: a byte that is not what was rendered
fails the run. The paper's figures are shown beside those of its own scene, cornell.sdl.

Examples:
  glint bench table
  glint bench table --sizes 512 --depths 0,1,2 --seconds 5 --json table.json
  glint bench table --scene mirrors --surface none --threads 1)";

struct BenchTableOptions {
    SceneOptions scene;
    bench::TableOptions table;
    std::optional<uint32_t> threads;
    bench::SurfaceKind surface = bench::SurfaceKind::egl;
    std::string json_file, csv_file, markdown_file;
};

ExitCode write_reports(const BenchTableOptions &options, const bench::Table &table) {
    using Report = std::pair<const std::string &, std::string (*)(const bench::Table &)>;
    const std::array reports{Report{options.json_file, &bench::to_json}, Report{options.csv_file, &bench::to_csv},
                             Report{options.markdown_file, &bench::to_markdown}};
    ExitCode code = ExitCode::ok;
    for (const auto &[file, form] : reports) {
        if (file.empty()) continue;
        if (const Status written = bench::write_report(file, form(table)); !written) code = fail(written.error());
    }
    return code;
}

ExitCode run(BenchTableOptions &options) {
    const Result<std::filesystem::path> path = find_scene(options.scene.file);
    if (!path) return fail_reading(path.error());
    options.table.threads = options.threads.value_or(0);
    if (someone_watches()) {
        options.table.on_row = [](uint32_t size_px, uint32_t depth) {
            complain(fmt::format("measuring {0}x{0}, depth {1}", size_px, depth));
        };
    }
    const Result<SceneFile> file = read_scene(*path, options.scene.read_options(*path));
    if (!file) return fail_reading(file.error());
    complain_about(*file);

    const uint32_t first_size = options.table.sizes_px.front();
    Result<bench::OpenedSurface> opened = bench::open_surface(options.surface, first_size, first_size);
    if (!opened) return fail(opened.error());
    for (const std::string &note : opened->notes) complain(note);

    const auto accel = Accel::build(file->scene, {.threads = options.table.threads});
    RenderControl control;
    const InterruptGuard guard(control);
    const Result<bench::Table> table =
        bench::measure_table(accel, scene_name(options.scene.file), opened->surface.get(), options.table, &control);
    if (!table) return fail(table.error());
    print(bench::to_text(*table));
    return write_reports(options, *table);
}

} // namespace

Command add_bench_table_command(CLI::App &bench) {
    auto options = std::make_shared<BenchTableOptions>();
    CLI::App *table = bench.add_subcommand("table", "The timing table of the 2013 paper, by resolution and depth");
    table
        ->add_option("--scene", options->scene.file,
                     "A scene file, or the name of one of Glint's scenes (default: cornell, the paper's)")
        ->type_name("NAME|FILE");
    add_numbers(*table, "--sizes", options->table.sizes_px, {1, 16384}, "Picture sizes (default 128,256,512)");
    add_numbers(*table, "--depths", options->table.depths, depth_bounds, "Recursive rays (default 1,2)");
    add_number(*table, "--threads", options->threads, thread_bounds, "Threads (default: one a processor)");
    add_choice(
        *table, "--surface", options->surface,
        {{"egl", bench::SurfaceKind::egl}, {"osmesa", bench::SurfaceKind::osmesa}, {"none", bench::SurfaceKind::none}},
        "What pictures are shown on: egl (default; falls back to osmesa, then none), osmesa, or none");
    add_isa(*table, options->table.isa);
    add_seconds(*table, options->table.min_seconds,
                "Time each row at least this long (default 1), and at least 50 frames");
    table->add_option("--json", options->json_file, "Write the table as JSON")->type_name("FILE");
    table->add_option("--csv", options->csv_file, "Write the table as CSV")->type_name("FILE");
    table->add_option("--md", options->markdown_file, "Write the table as Markdown")->type_name("FILE");
    add_scene_options(*table, options->scene);
    table->footer(examples);
    return {table, [options] { return run(*options); }};
}

} // namespace glint::cli
