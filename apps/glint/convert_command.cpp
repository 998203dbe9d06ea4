// glint convert: a scene file of any dialect becomes one of Glint's own.
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <glint/read.hpp>

#include "bench/report.hpp"
#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "scene_options.hpp"

namespace fs = std::filesystem;

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(The new file is in Glint's own SDL dialect, 'glint', and makes the same picture to the last bit,
whatever dialect the old one was in. Meshes are named relative to the new file's folder; without
-o, relative to the old one's. A file that was converted before comes out as it went in.

Examples:
  glint convert cornellroom.sdl                      prints the new file
  glint convert old/room.sdl -o new/room.sdl
  glint convert room.sdl --dialect path2005 -o clear.sdl)";

struct ConvertCommandOptions {
    SceneOptions scene;
    std::string output;
};

/// The file that the output would overwrite although the new scene is made of it, or nothing.
const fs::path *overwritten_source(const fs::path &output, const std::vector<fs::path> &sources) {
    for (const fs::path &source : sources) {
        std::error_code unknown; // an output that does not exist yet is nobody's
        if (fs::equivalent(output, source, unknown)) return &source;
    }
    return nullptr;
}

ExitCode run(const ConvertCommandOptions &options) {
    const fs::path input = options.scene.file;
    const bool to_file = !options.output.empty();
    const fs::path folder = to_file ? fs::path(options.output).parent_path() : input.parent_path();
    std::error_code unknown;
    if (to_file && !folder.empty() && !fs::is_directory(folder, unknown)) {
        return fail({ErrorCode::io,
                     fmt::format("cannot write '{}': there is no folder '{}'", options.output, folder.string())});
    }
    const Result<ConvertedScene> converted = convert_scene(input, folder, options.scene.read_options(input));
    if (!converted) return fail_reading(converted.error());
    complain_about(converted->source);

    std::vector<fs::path> sources = converted->source.mesh_files;
    sources.push_back(input);
    if (const fs::path *source = to_file ? overwritten_source(options.output, sources) : nullptr) {
        complain(fmt::format("-o: '{}' is '{}', which the new file is made from; choose another name", options.output,
                             source->string()));
        return ExitCode::usage;
    }
    if (to_file) {
        const Status written = bench::write_report(options.output, converted->text);
        if (!written) return fail(written.error());
    } else {
        print(converted->text);
    }
    if (converted->scene_root) {
        complain(fmt::format("note: the new file names files outside its own folder: it needs --scene-root {}",
                             converted->scene_root->string()));
    }
    return ExitCode::ok;
}

} // namespace

Command add_convert_command(CLI::App &parser) {
    auto options = std::make_shared<ConvertCommandOptions>();
    CLI::App *convert = parser.add_subcommand("convert", "Rewrite a scene file in Glint's own SDL dialect");
    convert->add_option("SCENE", options->scene.file, "The scene file (SDL)")->required()->type_name("");
    convert->add_option("-o,--output", options->output, "The new file (default: standard output)")->type_name("FILE");
    add_scene_options(*convert, options->scene);
    convert->footer(examples);
    return {convert, [options] { return run(*options); }};
}

} // namespace glint::cli
