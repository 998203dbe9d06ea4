// Where the render command writes when the user does not say.
#include "picture_file.hpp"

#include "inside.hpp"

namespace fs = std::filesystem;

namespace glint::cli {

Result<fs::path> default_picture_file(const SceneOptions &options, const SceneFile &scene) {
    const fs::path scene_file = options.file;
    if (!scene.output_file) return scene_file.stem().concat(".png");

    const fs::path root = options.root_for(scene_file);
    const fs::path wanted = scene_file.parent_path() / *scene.output_file; // an absolute output replaces the folder
    if (!options.allow_outside_root && !is_inside(wanted, root)) {
        return Error(ErrorCode::bad_input,
                     "the scene's output '" + *scene.output_file + "' is outside the scene root '" + root.string() +
                         "'",
                     "choose a file with -o, or pass --allow-outside-root");
    }
    return wanted;
}

} // namespace glint::cli
