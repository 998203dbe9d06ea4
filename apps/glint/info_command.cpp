// glint info: what a scene file says, as it was understood.
#include <memory>

#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "scene_options.hpp"
#include "scene_report.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples = R"(Examples:
  glint info cornell.sdl
  glint info cornell.sdl --json | python3 -m json.tool)";

struct InfoCommandOptions {
    SceneOptions scene;
    bool json = false;
};

ExitCode run(const InfoCommandOptions &options) {
    const Result<SceneFile> file = read_scene(options.scene.file, options.scene.read_options(options.scene.file));
    if (!file) return fail_reading(file.error());
    const std::shared_ptr<const Accel> accel = Accel::build(file->scene);
    print(options.json ? scene_report_json(options.scene.file, *file, *accel)
                       : scene_report_text(options.scene.file, *file, *accel));
    return ExitCode::ok;
}

} // namespace

Command add_info_command(CLI::App &parser) {
    auto options = std::make_shared<InfoCommandOptions>();
    CLI::App *info = parser.add_subcommand("info", "Say what a scene file holds, and what its kd-tree is like");
    info->add_option("SCENE", options->scene.file, "The scene file (SDL)")->required()->type_name("");
    info->add_flag("--json", options->json, "Print JSON");
    add_scene_options(*info, options->scene);
    info->footer(examples);
    return {info, [options] { return run(*options); }};
}

} // namespace glint::cli
