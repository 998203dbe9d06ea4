// The options of every command that reads a scene, and the reading itself.
#include "scene_options.hpp"

#include <glint/imageio.hpp>

#include "console.hpp"
#include "inside.hpp"

namespace fs = std::filesystem;

namespace glint::cli {

ReadOptions SceneOptions::read_options(const fs::path &path) const {
    ReadOptions options;
    options.limits.max_pixels = pixel_limit();
    options.scene_root = root_for(path);
    options.allow_outside_root = allow_outside_root;
    options.dialect = dialect;
    options.read_texture = &read_texture;
    options.flat = flat;
    return options;
}

fs::path SceneOptions::root_for(const fs::path &path) const {
    if (!scene_root.empty()) return scene_root;
    const fs::path own = path.has_parent_path() ? path.parent_path() : fs::path(".");
    // In the root of all files everybody is inside everything: that would be no bound at all.
    const fs::path here = real_path(".");
    return here != here.root_path() && is_inside(own, here) ? fs::path(".") : own;
}

void add_scene_options(CLI::App &parser, SceneOptions &options) {
    const auto group = std::string("Reading the scene");
    add_number(parser, "--max-pixels", options.max_pixels, {1, uint64_t{1} << 40},
               "Most pixels a picture may have (default 67108864)")
        ->group(group);
    parser
        .add_option("--scene-root", options.scene_root,
                    "Folder that no path in the scene file may leave; files are looked for up to it (default: the "
                    "current folder if the scene is inside it, else the scene file's own)")
        ->type_name("DIR")
        ->group(group);
    parser
        .add_flag("--allow-outside-root", options.allow_outside_root,
                  "Follow absolute paths and paths that leave the scene root")
        ->group(group);
    parser
        .add_option("--dialect", options.dialect,
                    "Read the file as this SDL dialect, e.g. mobile2013 (default: detect)")
        ->type_name("NAME")
        ->group(group);
    parser.add_flag("--flat", options.flat, "Leave the normals of OBJ files aside: every triangle is flat")
        ->group(group);
}

void complain_about(const SceneFile &file) {
    for (const Diagnostic &warning : file.warnings) complain(warning.text());
}

} // namespace glint::cli
