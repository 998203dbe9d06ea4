// glint bench moving: what it costs to move a scene's objects from one frame to the next.
#include <memory>
#include <optional>

#include <fmt/format.h>

#include <glint/glint.hpp>

#include "bench/update_cost.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "named_scene.hpp"
#include "number_options.hpp"
#include "scene_options.hpp"

namespace glint::cli {
namespace {

struct BenchMovingOptions {
    SceneOptions scene;
    std::optional<uint32_t> frames;
};

ExitCode run(const BenchMovingOptions &options) {
    const Result<std::filesystem::path> path = find_scene(options.scene.file);
    if (!path) return fail_reading(path.error());
    const Result<SceneFile> file = read_scene(*path, options.scene.read_options(*path));
    if (!file) return fail_reading(file.error());
    complain_about(*file);
    if (!file->scene->animation()) {
        complain("nothing moves in this scene");
        return ExitCode::bad_input;
    }
    const Result<bench::UpdateCost> cost = bench::measure_updates(file->scene, options.frames.value_or(500));
    if (!cost) return fail(cost.error());
    print(fmt::format("moving objects   {}\nmoving triangles {}\nupdates          {}\n", cost->moving_objects,
                      cost->moving_triangles, cost->updates));
    const auto row = [](const char *what, const bench::Summary &ms) {
        print(fmt::format("{:<16} median {:.4f}  min {:.4f}  p95 {:.4f}\n", what, ms.median, ms.min, ms.p95));
    };
    row("scene edit, ms", cost->edit_ms);
    row("tree, ms", cost->accel_ms);
    row("update, ms", cost->update_ms);
    return ExitCode::ok;
}

} // namespace

Command add_bench_moving_command(CLI::App &bench) {
    auto options = std::make_shared<BenchMovingOptions>();
    options->scene.file = "carousel";
    CLI::App *moving = bench.add_subcommand("moving", "Moving a scene's objects, without rendering");
    moving
        ->add_option("--scene", options->scene.file,
                     "A scene file, or the name of one of Glint's scenes (default: carousel, a hundred rings)")
        ->type_name("NAME|FILE");
    add_number(*moving, "--frames", options->frames, {1, 1'000'000}, "So many updates (default 500)");
    add_scene_options(*moving, options->scene);
    return {moving, [options] { return run(*options); }};
}

} // namespace glint::cli
