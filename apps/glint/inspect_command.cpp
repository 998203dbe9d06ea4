// glint inspect: where a pixel's colour comes from, ray by ray.
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <glint/glint.hpp>

#include "command.hpp"
#include "console.hpp"
#include "failure.hpp"
#include "number_options.hpp"
#include "ray_tree_report.hpp"
#include "sample_options.hpp"
#include "scene_options.hpp"

namespace glint::cli {
namespace {

constexpr const char *examples =
    R"(The picture is the one that `glint render` makes with the same options; pixel 0,0 is its top
left one. A line for each ray, indented below the ray that sent it:
  weight      the ray's share in its sample
  own         the share of what it ends at, without what is mirrored and transmitted there
  red ...     what it ends at, as it shows itself; of a light: what it adds to the line above
  distance    to where it ends, in the scene's units
The pixel is the sum of own times colour over all rays, divided by the number of samples.

JSON has, besides the options: color (linear), rgba8, and rays, a list in which a ray stands
before those that it sent, each with
  kind            "primary", "mirror", "transmitted" or "shadow" (towards a light)
  parent          the place in the list of the ray that sent it, from 0, or null
  level, sample   rays above it; which of the pixel's samples it belongs to
  origin, direction (unit length), distance (null: endless)
  target          {kind: "background", "object" or "light", index, name}, as `glint info` lists them;
                  of a shadow ray the light or, where not all light comes through, what is in the way
  weight, local_weight, local_color     as above
  contribution    what it and all rays below bring to the sample; of a shadow ray: to its parent's
  light, light_name, light_share     of a shadow ray: the light's index and name, and the share of
                  it that comes through; else null

Examples:
  glint inspect cornell.sdl --pixel 300,380 --size 512x512 --depth 2
  glint inspect cornell.sdl --pixel 0,0 --spp 4 --json | python3 -m json.tool)";

struct Pixel {
    uint32_t x, y;
};

struct InspectCommandOptions {
    SceneOptions scene;
    std::optional<Pixel> pixel;
    std::optional<Size> size;
    SampleOptions samples;
    bool json = false;
};

/// "300,380"; both within a picture of any size.
std::optional<Pixel> parse_pixel(std::string_view text) {
    const size_t comma = text.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    constexpr Bounds bounds{0, side_bounds.max - 1};
    const auto x = parse_whole_number(text.substr(0, comma), bounds);
    const auto y = parse_whole_number(text.substr(comma + 1), bounds);
    if (!x || !y) return std::nullopt;
    return Pixel{static_cast<uint32_t>(*x), static_cast<uint32_t>(*y)};
}

void add_pixel(CLI::App &parser, std::optional<Pixel> &target) {
    const auto read = [&target](const std::string &text) {
        target = parse_pixel(text);
        if (target) return;
        throw CLI::ValidationError("--pixel",
                                   fmt::format("'{}' is not a pixel like 300,380: column and row, from 0", text));
    };
    parser.add_option_function<std::string>("--pixel", read, "The pixel: its column and row, from the top left")
        ->type_name("X,Y")
        ->required();
}

ExitCode run(const InspectCommandOptions &options) {
    const Result<SceneFile> file = read_scene(options.scene.file, options.scene.read_options(options.scene.file));
    if (!file) return fail_reading(file.error());
    complain_about(*file);
    const PictureSettings &picture = file->scene->picture();
    const Size size = options.size.value_or(Size{picture.width_px, picture.height_px});
    const Pixel &pixel = *options.pixel;
    if (pixel.x >= size.width_px || pixel.y >= size.height_px) {
        complain(fmt::format("--pixel: {},{} lies outside of the picture, which has {}x{} pixels; choose another size "
                             "with --size",
                             pixel.x, pixel.y, size.width_px, size.height_px));
        return ExitCode::usage;
    }
    const Result<RayTree> tree = trace_ray_tree(*Accel::build(file->scene), options.samples.render_options(),
                                                size.width_px, size.height_px, pixel.x, pixel.y);
    if (!tree) return fail(tree.error());
    print(options.json ? ray_tree_json(options.scene.file, *tree) : ray_tree_text(options.scene.file, *tree));
    return ExitCode::ok;
}

} // namespace

Command add_inspect_command(CLI::App &parser) {
    auto options = std::make_shared<InspectCommandOptions>();
    CLI::App *inspect = parser.add_subcommand("inspect", "Say where a pixel's colour comes from, ray by ray");
    inspect->add_option("SCENE", options->scene.file, "The scene file (SDL)")->required()->type_name("");
    add_pixel(*inspect, options->pixel);
    add_size(*inspect, "--size", options->size, "Picture size (default: the scene's)");
    add_sample_options(*inspect, options->samples);
    inspect->add_flag("--json", options->json, "Print JSON");
    add_scene_options(*inspect, options->scene);
    inspect->footer(examples);
    return {inspect, [options] { return run(*options); }};
}

} // namespace glint::cli
